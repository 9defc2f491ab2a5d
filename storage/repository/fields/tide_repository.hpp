#pragma once

#include <complex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/currents/tide_grid.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Harmonic constants of one quantity at a place where it was measured or computed.
struct TideStation {
  std::string name;  // empty: not named in the source
  geo::LonLat place;
  ocean::TideQuantity quantity{ocean::TideQuantity::elevation};
  std::vector<tide::HarmonicConstant> constants;
};

/// Tides: tide models on a grid, and stations.
/// Threads  as the connection: one thread at a time
class TideRepository {
 public:
  explicit TideRepository(sql::Connection& db) : db_{db} {}

  void create(const DatasetId& id, const ocean::HorizontalGrid& grid);
  /// Writes one field [y][x] of a grid that was created before.
  void write(const DatasetId& id, tide::Constituent constituent, ocean::TideQuantity quantity,
             std::span<const std::complex<float>> field);
  /// The nodes around `area`, at least one on each side if the grid has one. nullopt when the dataset has no
  /// grid, or no node in the area.
  [[nodiscard]] std::optional<ocean::TideGrid> load(const DatasetId& id, const geo::BoundingBox& area) const;

  void insert(const DatasetId& id, const std::vector<TideStation>& stations);
  /// The stations of a dataset, in the order of insertion.
  [[nodiscard]] std::vector<TideStation> stations(const DatasetId& id) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
