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

/// Number of levels down to the first at or below `deepest`.
std::size_t levels_to(const FieldShape& shape, core::Metres deepest) {
  if (!shape.depths_m) return 1;
  const auto above = static_cast<std::size_t>(std::ranges::count_if(
      shape.depths_m->nodes(), [&](double depth_m) { return depth_m < deepest.value; }));
  return std::min(above + 1, shape.depths_m->size());
}

}  // namespace

std::optional<CurrentsBox> drift_box(const EnvironmentDraft& draft, const Dataset& dataset, std::size_t steps,
                                     std::size_t most_samples) {
  const EnvironmentQuery& query = draft.query;
  if (!query.iceberg_drift || draft.environment.icebergs.empty()) return std::nullopt;
  const FieldRepository fields{draft.db};
  const auto shape = fields.shape(dataset.id);
  if (!shape) return std::nullopt;
  const core::Metres deepest = deepest_keel(draft);
  const std::size_t samples_a_node = levels_to(*shape, deepest) * steps;
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    const geo::BoundingBox area = geo::grown(query.area, core::Metres{share * reach_of_drift.value});
    if (fields.most_nodes(dataset.id, area) * samples_a_node <= most_samples)
      return CurrentsBox{area, deepest};
  }
  return CurrentsBox{query.area, deepest};
}

bool area_holds(const EnvironmentDraft& draft, const Dataset& dataset, const CurrentsBox& box,
                const ocean::CurrentGrid::Samples& of_area) {
  const FieldRepository fields{draft.db};
  const auto shape = fields.shape(dataset.id);
  if (!shape || !box.deepest || of_area.depths_m.has_value() != shape->depths_m.has_value()) return false;
  const std::size_t levels = of_area.depths_m ? of_area.depths_m->size() : 1;
  // The box encloses the area, so equal counts of nodes mean the same nodes.
  return levels >= levels_to(*shape, *box.deepest) &&
         fields.most_nodes(dataset.id, box.area) == fields.most_nodes(dataset.id, draft.query.area);
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
