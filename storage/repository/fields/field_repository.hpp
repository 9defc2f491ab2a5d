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

/// Shape of the gridded data of one dataset. Of data that are kept at a model's own points the grid is the one on which
/// they are interpolated when they are read, and the depths are those of plans where the levels follow the sea bed.
struct FieldShape {
  ocean::HorizontalGrid grid;
  std::optional<ocean::Axis> depths_m;  // empty: no depth axis
  std::optional<ocean::Axis> times_s;   // empty: no time
};

/// A model's own points, at which the data of a dataset are kept.
struct NativePoints {
  const ocean::Mesh& mesh;   // numbered by `in_blocks`
  std::size_t bed_levels{};  // that follow the sea bed; 0: the levels are the depths of the shape
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
  /// Rows of a slice that are packed together.
  static constexpr std::size_t rows_together = 64;

  explicit FieldRepository(sql::Connection& db, std::stop_token stop = {})
      : db_{db}, stop_{std::move(stop)} {}

  void create(const DatasetId& id, const FieldShape& shape);
  void create(const DatasetId& id, const FieldShape& shape, const NativePoints& native);
  /// One horizontal slice [y][x], or [point], NaN where missing; indices are 0 where the shape has no such axis.
  /// `steps`  in which the values were counted, where that is known: they take less room then
  void write_slice(const DatasetId& id, const std::string& variable, std::size_t time_index,
                   std::size_t depth_index, std::span<const float> values, const SampleSteps& steps = {});
  /// Some whole rows of the only slice, [y][x], where a grid is too large to be held at once: from a multiple of
  /// `rows_together` on to another, or to the last row.
  void write_rows(const DatasetId& id, const std::string& variable, std::size_t first_row,
                  std::span<const float> values);

  [[nodiscard]] std::optional<FieldShape> shape(const DatasetId& id) const;

  /// About how many nodes load_currents has in an area, or more: of data at a model's own points it is not known before
  /// they are read. 0 when the dataset is unknown or has no node there.
  [[nodiscard]] std::size_t most_nodes(const DatasetId& id, const geo::BoundingBox& area) const;

  /// The nodes around `area` (one more on each side), the times around `period` and the levels down to the first at or
  /// below `deepest`, from the last level at or above `shallowest` on. nullopt when the dataset is unknown or shares no
  /// node with the area, or no time with the period. A dataset whose period ends before or begins after `period` yields
  /// nullopt; `period` empty means all times.
  [[nodiscard]] std::optional<ocean::CurrentGrid> load_currents(
      const DatasetId& id, const geo::BoundingBox& area, std::optional<Period> period,
      std::optional<core::Metres> deepest, std::optional<core::Metres> shallowest = {}) const;
  /// The same about a place, with all the nodes that are packed together with those around it: they are unpacked in any
  /// case, and who asks for one place asks for those beside it next. null: as above.
  [[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> load_currents_at(
      const DatasetId& id, geo::LonLat place, std::optional<Period> period,
      std::optional<core::Metres> deepest, std::optional<core::Metres> shallowest, CurrentBlocks& kept) const;
  [[nodiscard]] std::optional<ocean::Bathymetry> load_bathymetry(const DatasetId& id,
                                                                 const geo::BoundingBox& area) const;
  /// Does what load_currents does, without depths. It has thickness if a slice of thickness was ever written.
  [[nodiscard]] std::optional<ocean::IceField> load_ice(const DatasetId& id, const geo::BoundingBox& area,
                                                        std::optional<Period> period) const;

  /// Names of the variables that were ever written, ascending.
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
