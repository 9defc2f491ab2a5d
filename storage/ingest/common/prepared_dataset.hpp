#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/grid_frame.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::ingest {

/// Where a dataset has its values. If an older program stored a file in another way, reading it again makes a
/// second dataset with its own id.
enum class Keeping { on_a_grid, at_own_points, at_points_of_components, on_a_projected_grid };

/// Of values at the nodes of a grid. Older programs had grids in longitude and latitude, polar stereographic on two
/// ellipsoids and transverse Mercator on one, which they took for GRS 1980, too.
[[nodiscard]] inline Keeping keeping_on(const geo::GridFrame& frame) {
  const auto* polar = std::get_if<geo::PolarStereographicFrame>(&frame);
  const auto* mercator = std::get_if<geo::TransverseMercatorFrame>(&frame);
  const bool is_old = std::holds_alternative<geo::GeographicFrame>(frame) ||
                      (polar != nullptr && polar->scale_ts == 1.0 &&
                       (polar->ellipsoid == geo::wgs84 || polar->ellipsoid == geo::hughes_1980)) ||
                      (mercator != nullptr && mercator->ellipsoid == geo::wgs84);
  return is_old ? Keeping::on_a_grid : Keeping::on_a_projected_grid;
}

/// One kind of data of a file, completely read and checked, with the function that writes it to the store.
/// The dataset's row must be inserted first.
struct PreparedDataset {
  repository::DatasetKind kind{};
  std::vector<std::string> variables;  // as the file names them
  geo::BoundingBox bounds;
  std::optional<core::UtcTime> time_start;
  std::optional<core::UtcTime> time_end;
  std::optional<core::UtcTime> run{};  // when the model run began; empty: the file does not say
  Keeping keeping{Keeping::on_a_grid};
  std::int64_t rows_accepted{};
  std::int64_t rows_refused{};
  Messages warnings;
  /// Runs inside the file's transaction. Refuses when the file can no longer be read.
  std::function<Checked<void>(sql::Connection&, const repository::DatasetId&)> write;
};

}  // namespace floeplan::ingest
