#include "storage/ingest/readers/currents/current_dataset.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "engine/messages/ingest_current_messages.hpp"
#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/ocean/currents/level_columns.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "engine/ocean/grids/staggered_sampling.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/current_survey.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"

namespace floeplan::ingest {
namespace {

class OneLevel : public VelocitySource {
 public:
  OneLevel(std::shared_ptr<const VelocitySource> source, std::size_t level, std::optional<double> depth_m)
      : source_{std::move(source)}, level_{level}, shape_{source_->shape()} {
    shape_.levels = 1;
    shape_.depths_m.reset();
    if (depth_m) shape_.depths_m = {*depth_m};
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return source_->place(point); }
  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t /*level*/) const override {
    return source_->read(time, level_);
  }
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const override {
    return source_->level_depths(time, level);
  }

 private:
  std::shared_ptr<const VelocitySource> source_;
  std::size_t level_;
  SourceShape shape_;
};

/// A source with only one level of another source.
/// `depth_m`  depth of the level, positive down; nullopt: without a depth
std::shared_ptr<const VelocitySource> one_level(std::shared_ptr<const VelocitySource> source,
                                                std::size_t level, std::optional<double> depth_m) {
  return std::make_shared<const OneLevel>(std::move(source), level, depth_m);
}

/// A source, the land found in it, and where its points are kept.
struct StoredCurrents {
  std::shared_ptr<const VelocitySource> source;
  std::shared_ptr<const ZeroLand> land;
  std::shared_ptr<const ComponentSource> components;   // null: both components lie at the source's points
  ocean::HorizontalGrid grid;                          // the grid of the points, or the grid for use in plans
  std::optional<repository::MeshInBlocks> own_points;  // empty: the points are the grid's nodes
  // depths of the levels; if the levels follow the sea bed, depths for use in plans
  std::optional<std::vector<double>> depths_m;

  [[nodiscard]] std::size_t times() const { return source->shape().times_s.size(); }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const {
    auto slice = source->read(time, level);
    for (std::size_t i = 0; slice && land && i < slice->east.size(); ++i)
      if (land->is_land(level, i)) slice->east[i] = slice->north[i] = missing;
    return slice;
  }

  /// The values in the order in which they are stored.
  [[nodiscard]] std::vector<float> as_kept(std::vector<float> values) const {
    return own_points ? own_points->in_order(values) : values;
  }
};

/// Writes the slice of one level at one time.
Checked<void> write_slice(const StoredCurrents& currents, std::size_t time, std::size_t level,
                          repository::FieldRepository& fields, const repository::DatasetId& id) {
  if (currents.components) {
    auto slice = currents.components->read(time, level, currents.land.get());
    if (!slice) return refuse(slice.error());
    fields.write_slice(id, "component_m_s", time, level, currents.as_kept(std::move(slice->values)),
                       slice->steps);
    return {};
  }
  auto slice = currents.read(time, level);
  if (!slice) return refuse(slice.error());
  fields.write_slice(id, "u_m_s", time, level, currents.as_kept(std::move(slice->east)), slice->east_steps);
  fields.write_slice(id, "v_m_s", time, level, currents.as_kept(std::move(slice->north)), slice->north_steps);
  return {};
}

/// Writes all slices of one time.
Checked<void> write_time(const StoredCurrents& currents, std::size_t time,
                         repository::FieldRepository& fields, const repository::DatasetId& id) {
  const SourceShape& shape = currents.source->shape();
  for (std::size_t level = 0; level < shape.levels; ++level)
    if (const auto written = write_slice(currents, time, level, fields, id); !written) return written;
  if (!shape.levels_follow_bed) return {};
  for (std::size_t level = 0; level <= shape.levels; ++level) {
    auto depths_m = currents.components ? currents.components->level_depths(time, level)
                                        : currents.source->level_depths(time, level);
    if (!depths_m) return refuse(depths_m.error());
    fields.write_slice(id, "level_depth_m", time, level, currents.as_kept(std::move(*depths_m)));
  }
  return {};
}

Checked<void> write_currents(const StoredCurrents& currents, const core::ProgressCallback& progress,
                             sql::Connection& db, const repository::DatasetId& id) {
  const SourceShape& source = currents.source->shape();
  repository::FieldRepository fields{db};
  std::optional<ocean::Axis> depths;
  if (currents.depths_m) depths = ocean::Axis{*currents.depths_m};
  const repository::FieldShape shape{currents.grid, std::move(depths), ocean::Axis{source.times_s}};
  if (currents.own_points)
    fields.create(id, shape, {currents.own_points->mesh, source.levels_follow_bed ? source.levels : 0});
  else
    fields.create(id, shape);
  if (currents.components) {
    fields.write_slice(id, "first_axis_rad", 0, 0, currents.as_kept(currents.components->axes().first_rad));
    fields.write_slice(id, "second_axis_rad", 0, 0, currents.as_kept(currents.components->axes().second_rad));
  }
  for (std::size_t time = 0; time < currents.times(); ++time) {
    if (const auto written = write_time(currents, time, fields, id); !written) return written;
    if (progress)
      progress("storing", 0.5 + 0.5 * static_cast<double>(time + 1) / static_cast<double>(currents.times()));
  }
  return {};
}

/// The greatest depth of the sea bed at the first time.
Checked<double> deepest_m(const VelocitySource& source) {
  const auto bed_m = source.level_depths(0, source.shape().levels);
  if (!bed_m) return refuse(bed_m.error());
  double deepest = 0.0;
  for (const float depth : *bed_m)
    if (static_cast<double>(depth) > deepest) deepest = static_cast<double>(depth);
  if (deepest <= 0.0) return refuse(messages::ingest_current_message<"sea-without-depth">());
  return deepest;
}

/// The grid to which plans interpolate currents of a mesh.
Checked<ocean::HorizontalGrid> grid_of_use(const CurrentInput& input) {
  auto grid = ocean::lattice_for(input.mesh);
  if (!grid) return refuse(messages::ingest_grid_message<"positions-enclose-no-area">());
  const bool usable =
      input.components ? ocean::StaggeredSampling::of(input.mesh, input.components->axes(), *grid).has_value()
                       : ocean::MeshSampling::of(input.mesh, *grid).has_value();
  if (!usable) return refuse(messages::ingest_grid_message<"cells-overlap">());
  return std::move(*grid);
}

/// Decides where the values are stored: on the source's grid, or at its own points.
Checked<StoredCurrents> placed(const CurrentInput& input, std::shared_ptr<const ZeroLand> land) {
  const SourceShape& shape = input.source->shape();
  std::optional<std::vector<double>> depths_m = shape.depths_m;
  if (shape.levels_follow_bed) {
    const auto deepest = deepest_m(*input.source);
    if (!deepest) return refuse(deepest.error());
    depths_m = ocean::standard_depths_m(*deepest);
  }
  if (input.grid)
    return StoredCurrents{input.source, std::move(land), nullptr,
                          *input.grid,  std::nullopt,    std::move(depths_m)};
  auto grid = grid_of_use(input);
  if (!grid) return refuse(grid.error());
  return StoredCurrents{input.source,
                        std::move(land),
                        input.components,
                        std::move(*grid),
                        repository::in_blocks(input.mesh),
                        std::move(depths_m)};
}

/// Warns of values with the file's own quality flags.
void warn_of_flags(const FlagCount& flagged, Messages& warnings) {
  if (flagged.bad > 0)
    warnings.push_back(messages::ingest_current_message<"flagged-bad-left-out">(flagged.bad));
  if (flagged.doubtful > 0)
    warnings.push_back(messages::ingest_current_message<"flagged-suspect-kept">(flagged.doubtful));
}

/// A warning about the water above the first level, if that level is deeper than any model's uppermost layer.
std::optional<messages::Message> above_the_first_level(const StoredCurrents& currents) {
  // uppermost layer of coarse global models, such as ORCA2 of NEMO (31 levels)
  constexpr double uppermost_layer_m = 10.0;
  if (!currents.depths_m || currents.depths_m->front() <= uppermost_layer_m) return std::nullopt;
  const std::string first_m = number(currents.depths_m->front());
  return messages::ingest_current_message<"current-above-first-level">(first_m);
}

}  // namespace

void keep_level(CurrentInput& input, std::size_t level, std::optional<double> depth_m) {
  input.source = one_level(std::move(input.source), level, depth_m);
  if (input.components)
    input.components = std::make_shared<const ComponentSource>(input.components->of_level(level));
}

Checked<PreparedDataset> prepare_currents(CurrentInput input, const core::ProgressCallback& progress) {
  const SourceShape& shape = input.source->shape();
  if (shape.levels * shape.times_s.size() > max_grid_values / shape.points())
    return refuse(messages::ingest_current_message<"currents-too-large">(shape.times_s.size(), shape.levels,
                                                                         shape.points()));
  const auto found = survey(*input.source, input.what, input.states_unit, progress);
  if (!found) return refuse(found.error());
  if (found->valid == 0 && found->flagged.bad > 0)
    return refuse(
        messages::ingest_current_message<"currents-all-missing-or-flagged">(enumeration(input.variables)));
  if (found->valid == 0)
    return refuse(messages::ingest_current_message<"currents-all-missing">(enumeration(input.variables)));
  if (found->everything_is_zero)
    return refuse(messages::ingest_current_message<"currents-all-zero">(input.what == Moving::sea ? "current"
                                                                                                  : "wind"));

  auto currents = placed(input, found->land);
  if (!currents) return refuse(currents.error());

  PreparedDataset data;
  data.kind = input.what == Moving::sea ? repository::DatasetKind::currents : repository::DatasetKind::wind;
  data.variables = std::move(input.variables);
  data.warnings = std::move(input.warnings);
  if (found->undeclared_fill > 0)
    data.warnings.push_back(
        messages::ingest_current_message<"current-markers-left-out">(found->undeclared_fill));
  warn_of_flags(found->flagged, data.warnings);
  if (found->doubt) data.warnings.push_back(*found->doubt);
  if (found->land)
    data.warnings.push_back(
        messages::ingest_current_message<"zeros-taken-as-land">(number(100.0 * found->land->share(), 3)));
  if (auto above = above_the_first_level(*currents)) data.warnings.push_back(std::move(*above));
  if (currents->own_points) {
    data.keeping = currents->components ? Keeping::at_points_of_components : Keeping::at_own_points;
    const std::size_t points = ocean::points_with_values(currents->own_points->mesh);
    data.warnings.push_back(messages::ingest_grid_message<"kept-at-own-points">(points, input.layout));
    data.rows_accepted = static_cast<std::int64_t>(points);
  } else {
    data.keeping = keeping_on(currents->grid.frame());
    data.rows_accepted = static_cast<std::int64_t>(currents->grid.size());
  }
  if (shape.levels_follow_bed)
    data.warnings.push_back(messages::ingest_current_message<"levels-follow-bed">(shape.levels));
  data.bounds = currents->grid.bounds();
  data.time_start = core::from_unix_seconds(shape.times_s.front());
  data.time_end = core::from_unix_seconds(shape.times_s.back());
  data.write = [currents = std::move(*currents), progress](sql::Connection& db,
                                                           const repository::DatasetId& id) {
    return write_currents(currents, progress, db, id);
  };
  return data;
}

}  // namespace floeplan::ingest
