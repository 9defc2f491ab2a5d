#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "engine/messages/data_messages.hpp"
#include "storage/repository/environment/environment_draft.hpp"
#include "storage/repository/environment/environment_parts.hpp"

namespace floeplan::repository {
namespace {

/// Chosen: no mission that is planned in one piece lasts longer.
constexpr core::Seconds longest_mission{30.0 * 86400.0};
/// Chosen: ice that ended longer than this before the departure says nothing about keels at the departure.
constexpr core::Seconds longest_memory{30.0 * 86400.0};
/// Largest number of products that are read. Our choice: more than one for each day of such a mission.
constexpr std::size_t most_products = 40;
/// Chosen, because each has to be read: how many older products are checked for values in gaps of newer ones
/// that cover their whole time and area except gaps or land.
constexpr int most_looks_into_gaps = 3;

/// Whether a dataset has only areas of complete ice, such as fast ice, from a chart without codes; ingest
/// then names this variable. It has no values outside the areas, so as the newest ice it would hide known
/// concentrations.
bool is_areas_alone(const Dataset& dataset) { return dataset.variables == std::vector<std::string>{"ice"}; }

/// The period in which a plan may need ice: from the earliest departure to the end of a mission with the
/// latest one.
Period mission_of(const EnvironmentQuery& query) {
  const core::UtcTime latest = query.until ? std::max(query.depart, query.until->time) : query.depart;
  return {query.depart, latest + longest_mission};
}

/// The period in which data of this period are used, because they are held before and after it.
Period with_hold(const Period& period) {
  return {period.from - ocean::longest_ice_hold, period.to + ocean::longest_ice_hold};
}

bool is_over(const Dataset& dataset, const Period& mission) {
  const auto period = period_of(dataset);
  return period && with_hold(*period).to < mission.from;
}

/// Whether data of this period are used in the mission: as ice, or as the last known keels.
bool counts_in(const Period& period, const Period& mission) {
  return with_hold(period).from <= mission.to && period.to >= mission.from - longest_memory;
}

/// A dataset that is used.
struct Product {
  Dataset dataset;
  Period period;
  ocean::Axis steps_s;
  bool reaches_all_of_the_area{};
  std::shared_ptr<const ocean::IceField> ice;

  [[nodiscard]] bool has_thickness() const { return !ice->samples().thickness_m.empty(); }
  [[nodiscard]] ocean::IceMoment moment(core::UtcTime time) const {
    return ocean::ice_moment(steps_s.nodes(), core::unix_seconds(time));
  }
};

bool reaches_all_of(const geo::BoundingBox& area, const ocean::HorizontalGrid& grid) {
  return holds_all_over(area, 16, [&](geo::LonLat place) { return grid.locate(place).has_value(); });
}

/// Whether `these` data are preferred to `those` at a moment, if both have a value.
bool counts_before(const ocean::IceMoment& these, const ocean::IceMoment& those) {
  if (these.standing != those.standing) return these.standing > those.standing;
  return these.standing != ocean::IceStanding::own && these.away < those.away;
}

/// Whether data with `these` steps are preferred to newer data with `those` steps at any time of the mission.
/// It is enough to check some times: between them only the distances to the nearest steps change, and
/// linearly.
bool ever_counts_before(const ocean::Axis& these, const ocean::Axis& those, const Period& mission) {
  const double from_s = core::unix_seconds(mission.from);
  const double to_s = core::unix_seconds(mission.to);
  std::vector<double> times_s{from_s, to_s};
  for (const ocean::Axis* steps_s : {&these, &those}) {
    for (std::size_t i = 0; i < steps_s->size(); ++i) {
      const double step_s = (*steps_s)[i];
      const double next_s = (*steps_s)[std::min(i + 1, steps_s->size() - 1)];
      for (const double time_s :
           {step_s, 0.5 * (step_s + next_s), step_s - ocean::longest_ice_hold.count(),
            step_s - ocean::ice_speaks_before.count(), step_s + ocean::ice_speaks_after.count(),
            step_s + ocean::longest_ice_hold.count()})
        if (time_s > from_s && time_s < to_s) times_s.push_back(time_s);
    }
  }
  std::ranges::sort(times_s);
  const auto is_before = [&](double time_s) {
    return counts_before(ocean::ice_moment(these.nodes(), time_s), ocean::ice_moment(those.nodes(), time_s));
  };
  for (std::size_t i = 0; i + 1 < times_s.size(); ++i)
    if (is_before(times_s[i]) || is_before(0.5 * (times_s[i] + times_s[i + 1]))) return true;
  return is_before(to_s);
}

/// The preferred products that have data at all times of data with these steps, and in the whole area except
/// gaps.
std::vector<const Product*> covering(const ocean::Axis& steps_s, const Period& mission,
                                     const std::vector<Product>& before) {
  std::vector<const Product*> found;
  for (const Product& product : before)
    if (product.reaches_all_of_the_area && !ever_counts_before(steps_s, product.steps_s, mission))
      found.push_back(&product);
  return found;
}

bool holds_thickness(const FieldRepository& fields, const DatasetId& id) {
  const std::vector<std::string> names = fields.variables(id);
  return std::ranges::find(names, "thickness_m") != names.end();
}

bool knows_always(const ocean::IceField& ice, geo::LonLat place) {
  return std::ranges::all_of(ice.samples().times_s.nodes(), [&](double time_s) {
    return ice.at(place, core::from_unix_seconds(time_s)).has_value();
  });
}

/// Whether the ice has a value at a node of the area where none of these products always has one.
bool fills_a_gap(const ocean::IceField& ice, const geo::BoundingBox& area,
                 const std::vector<const Product*>& products) {
  const ocean::IceField::Samples& samples = ice.samples();
  const std::size_t nodes = samples.grid.size();
  const std::size_t columns = samples.grid.x().size();
  for (std::size_t node = 0; node < nodes; ++node) {
    const geo::LonLat place = samples.grid.place(node % columns, node / columns);
    bool is_known = false;
    for (std::size_t i = node; i < samples.concentration.size() && !is_known; i += nodes)
      is_known = !std::isnan(samples.concentration[i]);
    if (!is_known || !geo::contains(area, place)) continue;
    const auto knows = [&](const Product* product) { return knows_always(*product->ice, place); };
    if (std::ranges::none_of(products, knows)) return true;
  }
  return false;
}

/// The product that is preferred at a time, if all have a value at a place.
const Product& first_then(const std::vector<Product>& used, core::UtcTime time) {
  const Product* first = &used.front();
  for (const Product& product : used)
    if (counts_before(product.moment(time), first->moment(time))) first = &product;
  return *first;
}

void tell_of_the_departure(EnvironmentDraft& draft, const std::vector<Product>& used) {
  const core::UtcTime depart = draft.query.depart;
  const Product& now = first_then(used, depart);
  const ocean::IceMoment moment = now.moment(depart);
  const auto step = [&](std::size_t i) { return core::from_unix_seconds(now.steps_s[i]); };
  switch (moment.standing) {
    case ocean::IceStanding::own: return;
    case ocean::IceStanding::speaks:
    case ocean::IceStanding::held:
      if (moment.share > 0.0) return;
      return draft.tell(messages::data_message<"ice-held">(title(now.dataset), step(moment.first)));
    case ocean::IceStanding::unknown:
      return draft.tell(
          messages::data_message<"ice-unknown-at-departure">(title(now.dataset), step(moment.first)));
    case ocean::IceStanding::not_begun: break;
  }
  const core::UtcTime begin =
      std::ranges::min(used, {}, [](const Product& product) { return product.period.from; }).period.from;
  draft.tell(messages::data_message<"ice-not-begun">(begin, begin - ocean::longest_ice_hold));
}

void report(EnvironmentDraft& draft, const std::vector<Product>& used) {
  std::string names;
  for (const Product& product : used) {
    draft.cite(product.dataset);
    names += (names.empty() ? "" : ", then ") + title(product.dataset);
  }
  if (used.size() > 1) draft.tell(messages::data_message<"ice-joined">(names));
  tell_of_the_departure(draft, used);
}

void adopt_ice(EnvironmentDraft& draft, const std::vector<Product>& used) {
  const bool is_thickness_told = std::ranges::any_of(used, &Product::has_thickness);
  for (const Product& product : used) {
    if (!product.has_thickness())
      draft.tell(is_thickness_told
                     ? messages::data_message<"ice-with-thickness-of-others">(title(product.dataset))
                     : messages::data_message<"ice-without-thickness">(title(product.dataset)));
    if (!draft.environment.ice) {
      draft.environment.ice = product.ice;
    } else {
      draft.environment.further_ice.push_back(product.ice);
    }
  }
}

/// The datasets in the order in which they are read: first datasets of the mission's time, then datasets that
/// end before it, last datasets that hold only areas. So the last ones only fill gaps of the others.
std::vector<Dataset> in_order(std::vector<Dataset> found, const Period& mission) {
  std::ranges::stable_partition(found, [&](const Dataset& dataset) { return !is_over(dataset, mission); });
  std::ranges::stable_partition(found, std::not_fn(is_areas_alone));
  return found;
}

struct Choice {
  std::vector<Product> used;
  std::string periods_missed;
};

Choice choose(EnvironmentDraft& draft, const std::vector<Dataset>& found) {
  const EnvironmentQuery& query = draft.query;
  const Period mission = mission_of(query);
  const bool named = query.ice.how == DatasetChoice::How::named;
  const FieldRepository fields{draft.db, draft.reading.stop};
  Choice choice;
  std::vector<Product>& used = choice.used;
  int looks_into_gaps = 0;
  for (const Dataset& dataset : found) {
    const auto period = period_of(dataset);
    if (!period) continue;
    if (used.size() == most_products) {
      draft.tell(messages::data_message<"old-ice-not-asked">(most_products));
      break;
    }
    const bool tells_of_departure = std::ranges::any_of(
        used, [&](const Product& product) { return product.moment(query.depart).is_known(); });
    if (is_areas_alone(dataset) && tells_of_departure) break;
    if (named ? !covers(with_hold(*period), query.depart) : !counts_in(*period, mission)) {
      choice.periods_missed += (choice.periods_missed.empty() ? "" : "; ") + coverage_text(dataset, *period);
      continue;
    }
    const auto shape = fields.shape(dataset.id);
    if (!shape || !shape->times_s) continue;
    std::vector<const Product*> before = covering(*shape->times_s, mission, used);
    if (!before.empty() && is_over(dataset, mission)) continue;
    const bool may_add_thickness = !before.empty() && std::ranges::none_of(before, &Product::has_thickness);
    if (may_add_thickness && holds_thickness(fields, dataset.id)) before.clear();
    if (!before.empty() && looks_into_gaps++ >= most_looks_into_gaps) continue;
    const Period wanted{std::clamp(query.depart, period->from, period->to),
                        std::clamp(mission.to, period->from, period->to)};
    auto ice = fields.load_ice(dataset.id, query.area, wanted);
    if (!ice || (!before.empty() && !fills_a_gap(*ice, query.area, before))) continue;
    const bool reaches_all = reaches_all_of(query.area, ice->samples().grid);
    used.push_back({dataset, *period, *shape->times_s, reaches_all,
                    std::make_shared<const ocean::IceField>(std::move(*ice))});
  }
  return choice;
}

/// Reports datasets with areas only that are not used because there is other ice.
void tell_of_unused_areas(EnvironmentDraft& draft, const std::vector<Dataset>& found,
                          const std::vector<Product>& used) {
  for (const Dataset& dataset : found) {
    const bool is_used =
        std::ranges::any_of(used, [&](const Product& product) { return product.dataset.id == dataset.id; });
    if (is_areas_alone(dataset) && !is_used && !is_areas_alone(used.front().dataset))
      draft.tell(messages::data_message<"ice-areas-not-used">(title(dataset), title(used.front().dataset)));
  }
}

}  // namespace

void add_ice(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  const bool named = query.ice.how == DatasetChoice::How::named;
  const auto found = in_order(
      candidates(draft.stored, DatasetKind::ice, query.ice, query.area, draft.violations), mission_of(query));
  if (named && query.ice.ids.size() > 1) {
    draft.refuse<"several-datasets">(DatasetKind::ice);
    return;
  }

  const auto [used, periods_missed] = choose(draft, found);
  if (!used.empty()) {
    adopt_ice(draft, used);
    report(draft, used);
    tell_of_unused_areas(draft, found, used);
  } else if (named && !periods_missed.empty()) {
    draft.refuse<"no-ice-then">(DatasetKind::ice, query.depart, periods_missed);
  } else if (named && !found.empty()) {
    draft.refuse<"no-node-near">(DatasetKind::ice, title(found.front()));
  } else if (!periods_missed.empty()) {
    draft.tell(messages::data_message<"ice-not-at-departure">(periods_missed));
  } else if (!named) {
    tell_of_gap(draft, query.ice, messages::data_message<"ice-left-out">(),
                messages::data_message<"ice-missing">(geo::bounds_text(named_area(query))));
  }
}

}  // namespace floeplan::repository
