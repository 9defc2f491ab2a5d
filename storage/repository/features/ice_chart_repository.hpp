#pragma once

#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// An attribute of a polygon of an ice chart and its code, as the chart has them: "CT", "91".
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

/// The polygons of ice charts, indexed by their boxes (R*Tree), for people to look at: plans obey the grid that the same
/// dataset has. Charts that were stored by older versions have none.
/// Threads  as the connection: one thread at a time
class IceChartRepository {
 public:
  explicit IceChartRepository(sql::Connection& db) : db_{db} {}

  /// Names and codes hold no blank and no equals sign.
  void insert(const DatasetId& dataset, const std::vector<ChartPolygon>& polygons);
  /// Every polygon whose box meets the area, whole, in the order of insertion.
  [[nodiscard]] std::vector<ChartPolygon> load(const DatasetId& dataset, const geo::BoundingBox& area) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
