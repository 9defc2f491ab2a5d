#include <algorithm>
#include <string>
#include <vector>

#include "engine/core/shown_text.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/ocean/ice/iceberg_draft.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "storage/repository/environment/environment_draft.hpp"
#include "storage/repository/environment/environment_parts.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::repository {
namespace {

core::Metres deepest_keel(const EnvironmentDraft& draft) {
  core::Metres deepest{0.0};
  for (const ocean::Iceberg& iceberg : draft.environment.icebergs)
    deepest = std::max(deepest, ocean::drift_draft(iceberg));
  return deepest;
}

/// Number of levels down to the first at or below `deepest`; all if it is empty.
std::size_t levels_to(const FieldShape& shape, std::optional<core::Metres> deepest) {
  if (!shape.depths_m) return 1;
  if (!deepest) return shape.depths_m->size();
  const auto above = static_cast<std::size_t>(std::ranges::count_if(
      shape.depths_m->nodes(), [&](double depth_m) { return depth_m < deepest->value; }));
  return std::min(above + 1, shape.depths_m->size());
}

}  // namespace

std::optional<CurrentsBox> drift_box(const EnvironmentDraft& draft, const Dataset& dataset, std::size_t steps,
                                     std::size_t most_samples) {
  const EnvironmentQuery& query = draft.query;
  if (!query.iceberg_drift || draft.environment.icebergs.empty()) return std::nullopt;
  if (!FieldRepository{draft.db}.shape(dataset.id)) return std::nullopt;
  const core::Metres deepest = deepest_keel(draft);
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    const CurrentsBox box{geo::grown(query.area, core::Metres{share * reach_of_drift.value}), deepest};
    if (most_samples_a_step(draft, dataset, box) * steps <= most_samples) return box;
  }
  return CurrentsBox{query.area, deepest};
}

std::size_t most_samples_a_step(const EnvironmentDraft& draft, const Dataset& dataset,
                                const CurrentsBox& box) {
  const FieldRepository fields{draft.db};
  const auto shape = fields.shape(dataset.id);
  return shape ? fields.most_nodes(dataset.id, box.area) * levels_to(*shape, box.deepest) : 0;
}

std::optional<CurrentsBox> box_of_both(const EnvironmentDraft& draft, const Dataset& dataset,
                                       const CurrentsBox& of_area, const CurrentsBox& of_drift) {
  constexpr double much_more = 1.5;  // times the samples of the area: a judgement
  // A tide is known in the area alone, and is told to be missing elsewhere.
  if (draft.query.tides.wanted()) return std::nullopt;
  CurrentsBox both{of_drift.area, std::nullopt};
  if (of_area.deepest && of_drift.deepest) both.deepest = std::max(*of_area.deepest, *of_drift.deepest);
  const auto samples = [&](const CurrentsBox& box) {
    return static_cast<double>(most_samples_a_step(draft, dataset, box));
  };
  return samples(both) <= much_more * samples(of_area) ? std::optional{both} : std::nullopt;
}

void tell_of_unknown_drift(EnvironmentDraft& draft) {
  const ocean::Environment& environment = draft.environment;
  if (!draft.query.iceberg_drift || !environment.currents) return;
  const ocean::CurrentGrid& carrying =
      environment.drift_currents ? *environment.drift_currents : *environment.currents;
  const bool always = environment.steady_currents;
  const core::UtcTime begin = core::from_unix_seconds(carrying.times_s().front());
  std::size_t seen_before = 0;
  std::size_t observed_before = 0;
  std::vector<std::string> names;
  for (const ocean::Iceberg& iceberg : environment.icebergs) {
    const bool is_before = !always && iceberg.observed < begin;
    if (is_before) ++seen_before;
    if (!always && !is_before && ocean::forecast_needs_from(iceberg) < begin) ++observed_before;
    const core::UtcTime from = is_before ? begin : iceberg.observed;
    const core::UtcTime until = std::max(draft.query.depart, from);
    if (!ocean::is_current_known(iceberg, environment, from, until, draft.reading.stop))
      names.push_back(iceberg.id.empty() ? "one without a name" : iceberg.id);
  }
  const std::size_t all = environment.icebergs.size();
  if (seen_before > 0)
    draft.tell(messages::data_message<"sightings-before-currents">(seen_before, all, begin));
  if (observed_before > 0)
    draft.tell(messages::data_message<"earlier-sightings-before-currents">(observed_before, all, begin));
  if (!names.empty())
    draft.tell(
        messages::data_message<"icebergs-beyond-currents">(names.size(), all, core::shortened_list(names)));
}

}  // namespace floeplan::repository
