#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "engine/ocean/ice/ice_field.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/encoding/sample_steps.hpp"
#include "storage/repository/fields/current_blocks.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Shape of the gridded data of one dataset. For data stored at a model's own points, `grid` is the grid to
/// which they are interpolated when read. If their levels follow the sea bed, `depths_m` are the depths to
/// which they are interpolated.
struct FieldShape {
  ocean::HorizontalGrid grid;
  std::optional<ocean::Axis> depths_m;  // empty: no depth axis
  std::optional<ocean::Axis> times_s;   // empty: no time
};

/// A model's own points, at which a dataset's data are stored.
struct NativePoints {
  const ocean::Mesh& mesh;  // numbered by `in_blocks`
  // number of levels that follow the sea bed; 0: the levels are the depths of the shape
  std::size_t bed_levels{};
};

/// Period of time, both ends included.
struct Period {
  core::UtcTime from;
  core::UtcTime to;
};

/// Gridded data in compressed chunks, so that a job reads only its area and period.
/// Data of models on bent grids and meshes are kept at the model's own points, in blocks of them, and interpolated
/// once, when they are read: on a grid that is as fine as they are, or at the one place that is asked for.
/// Variables are "depth_m" and (where cells are known to be shoaler) "shoalest_m" for bathymetry, "u_m_s" and "v_m_s"
/// for currents, or of a C grid "component_m_s" with "first_axis_rad" and "second_axis_rad" (the angle of a point's
/// component counterclockwise from east, under the name of its axis alone); "level_depth_m" where levels follow the sea
/// bed (the level after the last is the bed); "concentration" and (where known) "thickness_m" for ice.
/// Stops    reading early once `stop` is requested; what is returned then is incomplete and must not be used
/// Threads  as the connection: one thread at a time
class FieldRepository {
 public:
  /// Number of rows of a slice that are packed together.
  static constexpr std::size_t rows_together = 64;

  explicit FieldRepository(sql::Connection& db, std::stop_token stop = {})
      : db_{db}, stop_{std::move(stop)} {}

  void create(const DatasetId& id, const FieldShape& shape);
  void create(const DatasetId& id, const FieldShape& shape, const NativePoints& native);
  /// Writes one horizontal slice [y][x], or [point], NaN where missing. An index is 0 if the shape has no
  /// such axis.
  /// `steps`  steps in which the file stores the values, if they are packed; they then need less space
  void write_slice(const DatasetId& id, const std::string& variable, std::size_t time_index,
                   std::size_t depth_index, std::span<const float> values, const SampleSteps& steps = {});
  /// Writes some whole rows of the only slice, [y][x], of a grid that is too large for memory. The first row is
  /// a multiple of `rows_together`, and so is the end, unless it is the last row.
  void write_rows(const DatasetId& id, const std::string& variable, std::size_t first_row,
                  std::span<const float> values);

  [[nodiscard]] std::optional<FieldShape> shape(const DatasetId& id) const;

  /// An upper estimate of the number of nodes that load_currents returns for an area; for data at a model's
  /// own points the exact number is known only after reading. 0 when the dataset is unknown or has no node
  /// there.
  [[nodiscard]] std::size_t most_nodes(const DatasetId& id, const geo::BoundingBox& area) const;

  /// Reads currents: the nodes around `area` (one more on each side); the steps around `period`, all if it is
  /// empty; the levels from the last at or above `shallowest` to the first at or below `deepest`. nullopt
  /// when the dataset is unknown, has no node in the area, or ends before or begins after the period.
  [[nodiscard]] std::optional<ocean::CurrentGrid> load_currents(
      const DatasetId& id, const geo::BoundingBox& area, std::optional<Period> period,
      std::optional<core::Metres> deepest, std::optional<core::Metres> shallowest = {}) const;
  /// The same around a place, with all nodes that are packed together with those around it: they have to be
  /// unpacked anyway, and the next request is often for a neighbouring place. Null: as nullopt above. `kept`
  /// is the cache.
  [[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> load_currents_at(
      const DatasetId& id, geo::LonLat place, std::optional<Period> period,
      std::optional<core::Metres> deepest, std::optional<core::Metres> shallowest, CurrentBlocks& kept) const;
  [[nodiscard]] std::optional<ocean::Bathymetry> load_bathymetry(const DatasetId& id,
                                                                 const geo::BoundingBox& area) const;
  /// Loads sea ice as load_currents loads currents, but without depths. The result has a thickness if any
  /// slice of thickness is stored.
  [[nodiscard]] std::optional<ocean::IceField> load_ice(const DatasetId& id, const geo::BoundingBox& area,
                                                        std::optional<Period> period) const;

  /// One variable without depths at a place, at the steps around a period; NaN where it is missing. Between nodes it is
  /// interpolated bilinearly, or within the cell of its mesh.
  struct Series {
    ocean::Axis times_s;
    std::vector<float> values;
  };
  [[nodiscard]] std::optional<Series> load_series(const DatasetId& id, const std::string& variable,
                                                  geo::LonLat place, Period period) const;

  /// Names of all stored variables, ascending.
  [[nodiscard]] std::vector<std::string> variables(const DatasetId& id) const;
  /// Variables without depth and time on the nodes around `area`, [variable][y][x]; NaN where nothing was written. Of data
  /// on a grid alone.
  struct Planes {
    ocean::HorizontalGrid grid;
    std::vector<std::vector<float>> values;
  };
  [[nodiscard]] std::optional<Planes> load_planes(const DatasetId& id, const geo::BoundingBox& area,
                                                  std::span<const std::string> variables) const;

 private:
  sql::Connection& db_;  // borrowed
  std::stop_token stop_;
};

}  // namespace floeplan::repository
