#pragma once

#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// An attribute of a chart's polygon and its code: "CT", "91".
struct IceCode {
  std::string name;
  std::string code;

  friend bool operator==(const IceCode&, const IceCode&) = default;
};

/// A polygon of an ice chart with its egg code.
struct ChartPolygon {
  std::vector<IceCode> codes;
  geo::Polygon area;
};

/// The polygons of ice charts, indexed by their boxes (R*Tree), for display. Plans use the grid of the same
/// dataset. Charts stored by older versions have no polygons.
/// Threads  as the connection: one thread at a time
class IceChartRepository {
 public:
  explicit IceChartRepository(sql::Connection& db) : db_{db} {}

  /// Names and codes must not contain a blank or an equals sign.
  void insert(const DatasetId& dataset, const std::vector<ChartPolygon>& polygons);
  /// All polygons whose box intersects the area, uncut, in the order of insertion.
  [[nodiscard]] std::vector<ChartPolygon> load(const DatasetId& dataset, const geo::BoundingBox& area) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
