#include "storage/ingest/readers/currents/current_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/grids/depth_columns.hpp"
#include "storage/ingest/grids/resampling.hpp"
#include "storage/ingest/grids/target_grid.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/current_survey.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t max_batch_bytes = 64U << 20U;  // of slices at fixed depths that are held at a time

/// A source, the land found in it, and the way to the grid on which it is stored.
struct StoredCurrents {
  std::shared_ptr<const VelocitySource> source;
  std::shared_ptr<const ZeroLand> land;
  ocean::HorizontalGrid grid;
  std::shared_ptr<const Resampling> resampling;  // null: the source's points are the grid's nodes
  std::optional<std::vector<double>> depths_m;   // as stored

  [[nodiscard]] std::size_t levels() const { return depths_m ? depths_m->size() : 1; }
  [[nodiscard]] std::size_t times() const { return source->shape().times_s.size(); }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const {
    auto slice = source->read(time, level);
    for (std::size_t i = 0; slice && land && i < slice->east.size(); ++i)
      if (land->is_land(level, i)) slice->east[i] = slice->north[i] = std::numeric_limits<float>::quiet_NaN();
    return slice;
  }
};

/// Hands every stored slice of one time to `take(level, at the source's points, as stored)`, which may refuse.
template <class Take>
Checked<bool> for_each_level(const StoredCurrents& currents, std::size_t time, const Take& take) {
  const auto hand_on = [&](std::size_t level, const VelocitySlice& slice) -> Checked<bool> {
    if (!currents.resampling) return take(level, slice, slice);
    return take(level, slice, currents.resampling->apply(slice.east, slice.north));
  };
  const SourceShape& shape = currents.source->shape();
  if (!shape.levels_follow_bed) {
    for (std::size_t level = 0; level < shape.levels; ++level) {
      const auto slice = currents.read(time, level);
      if (!slice) return refuse(slice.error());
      if (const auto taken = hand_on(level, *slice); !taken) return taken;
    }
    return true;
  }
  const std::span<const double> depths_m{*currents.depths_m};
  const std::size_t batch = std::max<std::size_t>(1, max_batch_bytes / (2 * sizeof(float) * shape.points()));
  for (std::size_t first = 0; first < depths_m.size(); first += batch) {
    const auto slices = currents_at_depths(
        *currents.source, [&](std::size_t level) { return currents.read(time, level); }, time,
        depths_m.subspan(first, std::min(batch, depths_m.size() - first)));
    if (!slices) return refuse(slices.error());
    for (std::size_t i = 0; i < slices->size(); ++i)
      if (const auto taken = hand_on(first + i, (*slices)[i]); !taken) return taken;
  }
  return true;
}

Checked<void> write_currents(const StoredCurrents& currents, const core::ProgressCallback& progress,
                             sql::Connection& db, const repository::DatasetId& id) {
  repository::FieldRepository fields{db};
  std::optional<ocean::Axis> depths;
  if (currents.depths_m) depths = ocean::Axis{*currents.depths_m};
  fields.create(id, {currents.grid, std::move(depths), ocean::Axis{currents.source->shape().times_s}});
  for (std::size_t time = 0; time < currents.times(); ++time) {
    const auto written =
        for_each_level(currents, time,
                       [&](std::size_t level, const VelocitySlice& /*source*/,
                           const VelocitySlice& stored) -> Checked<bool> {
                         fields.write_slice(id, "u_m_s", time, level, stored.east, stored.east_steps);
                         fields.write_slice(id, "v_m_s", time, level, stored.north, stored.north_steps);
                         return true;
                       });
    if (!written) return refuse(written.error());
    if (progress)
      progress("storing", 0.5 + 0.5 * static_cast<double>(time + 1) / static_cast<double>(currents.times()));
  }
  return {};
}

/// The depth of the deepest sea bed at the first time.
Checked<double> deepest_m(const VelocitySource& source) {
  const auto bed_m = source.level_depths(0, source.shape().levels);
  if (!bed_m) return refuse(bed_m.error());
  double deepest = 0.0;
  for (const float depth : *bed_m)
    if (static_cast<double>(depth) > deepest) deepest = static_cast<double>(depth);
  if (deepest <= 0.0) return refuse(messages::ingest_current_message<"sea-without-depth">());
  return deepest;
}

/// "resampled from ...": what was done to the currents and how far they differ now.
Checked<messages::Message> account_of_resampling(const StoredCurrents& currents, const CurrentInput& input) {
  const std::string what = input.what == Moving::sea ? "current" : "wind";
  ResamplingError error;
  const auto compared = for_each_level(
      currents, 0,
      [&](std::size_t /*level*/, const VelocitySlice& source, const VelocitySlice& stored) -> Checked<bool> {
        error.add(input.mesh, source, currents.grid, stored);
        return true;
      });
  if (!compared) return refuse(compared.error());
  if (error.points() == 0)
    return refuse(messages::ingest_current_message<"nothing-left-after-resampling">(what, input.layout));
  const double speed = error.rms_speed_m_s();
  return messages::ingest_current_message<"currents-resampled">(
      input.layout, spacing_in_words(currents.grid), what + "s", number(error.rms_m_s(), 2),
      number(error.largest_m_s(), 2), speed > 0.0 ? " (RMS speed " + number(speed, 2) + " m/s)" : "");
}

/// Where the source is stored: on its own nodes, or resampled.
Checked<StoredCurrents> placed(const CurrentInput& input, std::shared_ptr<const ZeroLand> land) {
  const SourceShape& shape = input.source->shape();
  std::optional<std::vector<double>> depths_m = shape.depths_m;
  if (shape.levels_follow_bed) {
    const auto deepest = deepest_m(*input.source);
    if (!deepest) return refuse(deepest.error());
    depths_m = standard_depths_m(*deepest);
  }
  if (input.grid)
    return StoredCurrents{input.source, std::move(land), *input.grid, nullptr, std::move(depths_m)};
  auto grid = target_grid_for(input.mesh);
  if (!grid) return refuse(grid.error());
  auto resampling = Resampling::of(input.mesh, *grid);
  if (!resampling) return refuse(resampling.error());
  return StoredCurrents{input.source, std::move(land), std::move(*grid), std::move(*resampling),
                        std::move(depths_m)};
}

/// What the file's own quality flags left of its values.
void warn_of_flags(const FlagCount& flagged, Messages& warnings) {
  if (flagged.bad > 0)
    warnings.push_back(messages::ingest_current_message<"flagged-bad-left-out">(flagged.bad));
  if (flagged.doubtful > 0)
    warnings.push_back(messages::ingest_current_message<"flagged-suspect-kept">(flagged.doubtful));
}

/// What is taken for the water above the first level, where that is no model's uppermost layer.
std::optional<messages::Message> above_the_first_level(const StoredCurrents& currents) {
  constexpr double uppermost_layer_m = 10.0;  // of coarse global models, such as ORCA2 of NEMO (31 levels)
  if (!currents.depths_m || currents.depths_m->front() <= uppermost_layer_m) return std::nullopt;
  const std::string first_m = number(currents.depths_m->front());
  return messages::ingest_current_message<"current-above-first-level">(first_m);
}

std::optional<messages::Message> too_large(const StoredCurrents& currents) {
  if (currents.levels() * currents.times() <= max_grid_values / currents.grid.size()) return std::nullopt;
  return messages::ingest_current_message<"currents-too-large">(currents.times(), currents.levels(),
                                                                currents.grid.size());
}

}  // namespace

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
  if (auto fault = too_large(*currents)) return refuse(std::move(*fault));

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
  if (shape.levels_follow_bed)
    data.warnings.push_back(messages::ingest_current_message<"levels-interpolated">(
        shape.levels, currents->levels(), number(currents->depths_m->back())));
  if (currents->resampling) {
    auto account = account_of_resampling(*currents, input);
    if (!account) return refuse(account.error());
    data.warnings.push_back(std::move(*account));
  }
  data.bounds = currents->grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(currents->grid.size());
  data.time_start = core::from_unix_seconds(shape.times_s.front());
  data.time_end = core::from_unix_seconds(shape.times_s.back());
  data.write = [currents = std::move(*currents), progress](sql::Connection& db,
                                                           const repository::DatasetId& id) {
    return write_currents(currents, progress, db, id);
  };
  return data;
}

}  // namespace floeplan::ingest
