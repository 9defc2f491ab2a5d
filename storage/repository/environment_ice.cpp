#include "storage/repository/environment_ice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "storage/repository/area_lattice.hpp"

namespace floeplan::repository {
namespace {

/// No mission that is planned at once lasts longer.
constexpr core::Seconds longest_mission{30.0 * 86400.0};
/// More than one a day of such a mission. A judgement.
constexpr std::size_t most_products = 40;
/// Older ones of a time that newer ones tell of all over, but for land or gaps: looked at for what is in the gaps.
/// A judgement: each is read.
constexpr int most_looks_into_gaps = 3;

/// Areas that are all ice, such as fast ice, of a chart without codes: the variable that ingest names then. Outside
/// them nothing is known, so that as the newest ice they would hide a concentration that is.
bool is_areas_alone(const Dataset& dataset) { return dataset.variables == std::vector<std::string>{"ice"}; }

std::optional<Period> overlap(const Period& a, const Period& b) {
  const Period both{std::max(a.from, b.from), std::min(a.to, b.to)};
  return both.from <= both.to ? std::optional{both} : std::nullopt;
}

bool is_within(const Period& inner, const Period& outer) {
  return outer.from <= inner.from && inner.to <= outer.to;
}

/// When data of a period count.
struct Validity {
  explicit Validity(const Period& period)
      : speaks{period.from - ocean::ice_speaks_before, period.to + ocean::ice_speaks_after},
        held{period.from - ocean::longest_ice_hold, period.to + ocean::longest_ice_hold} {}

  Period speaks;
  Period held;
};

/// One that is used.
struct Product {
  Dataset dataset;
  Period period;
  Validity valid;
  bool reaches_all_of_the_area{};
  std::shared_ptr<const ocean::IceField> ice;
};

bool reaches_all_of(const geo::BoundingBox& area, const ocean::HorizontalGrid& grid) {
  return holds_all_over(area, 16, [&](geo::LonLat place) { return grid.locate(place).has_value(); });
}

/// Those before it that tell of all the times, and of all the area but for gaps, of which data with this validity do.
std::vector<const Product*> covering(const Validity& valid, const Period& mission,
                                     const std::vector<Product>& before) {
  const auto speaks = overlap(valid.speaks, mission);
  const auto held = overlap(valid.held, mission);
  std::vector<const Product*> found;
  for (const Product& product : before) {
    if (!product.reaches_all_of_the_area) continue;
    if (speaks ? is_within(*speaks, product.valid.speaks) : is_within(*held, product.valid.held))
      found.push_back(&product);
  }
  return found;
}

bool knows_always(const ocean::IceField& ice, geo::LonLat place) {
  return std::ranges::all_of(ice.samples().times_s.nodes(), [&](double time_s) {
    return ice.at(place, core::from_unix_seconds(time_s)).has_value();
  });
}

/// Whether the ice tells something of the area at a node where none of these products always does.
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

void warn_of_what_is_held(EnvironmentDraft& draft, const std::vector<Product>& used) {
  const core::UtcTime depart = draft.query.depart;
  const auto speaks = [&](const Product& product) { return covers(product.valid.speaks, depart); };
  const auto is_held = [&](const Product& product) { return covers(product.valid.held, depart); };
  const auto spoken = std::ranges::find_if(used, speaks);
  const auto now = spoken != used.end() ? spoken : std::ranges::find_if(used, is_held);
  if (now == used.end() || covers(now->period, depart)) return;
  draft.warn("ice of " + title(now->dataset) + " is held as at " +
             core::iso8601(depart > now->period.to ? now->period.to : now->period.from) +
             ", the step nearest to the departure");
}

void report(EnvironmentDraft& draft, const std::vector<Product>& used) {
  std::string names;
  for (const Product& product : used) {
    draft.cite(product.dataset);
    names += (names.empty() ? "" : ", then ") + title(product.dataset);
  }
  if (used.size() > 1)
    draft.warn("ice is taken from several datasets, each where or when those before it tell nothing: " +
               names);
  warn_of_what_is_held(draft, used);
}

void adopt(EnvironmentDraft& draft, const std::vector<Product>& used) {
  for (const Product& product : used) {
    if (product.ice->samples().thickness_m.empty())
      draft.warn("ice of " + title(product.dataset) +
                 " has no thickness: a draft is assumed wherever there is ice");
    if (!draft.environment.ice) {
      draft.environment.ice = product.ice;
    } else {
      draft.environment.further_ice.push_back(product.ice);
    }
  }
}

}  // namespace

void add_ice(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  auto found = candidates(draft.stored, DatasetKind::ice, query.ice, query.area, draft.violations);
  const auto areas = std::ranges::stable_partition(found, std::not_fn(is_areas_alone));
  const bool named = query.ice.how == DatasetChoice::How::named;
  if (named && query.ice.ids.size() > 1) {
    draft.refuse(DatasetKind::ice, "one dataset at a time; name the one to plan with");
    return;
  }

  const Period mission{query.depart, query.depart + longest_mission};
  const auto tells_of_departure = [&](const Product& product) {
    return covers(product.valid.held, query.depart);
  };
  std::string periods_missed;
  std::vector<Product> used;
  int looks_into_gaps = 0;
  for (const Dataset& dataset : found) {
    const auto period = period_of(dataset);
    if (!period) continue;
    if (used.size() == most_products) {
      draft.warn("more than " + std::to_string(most_products) +
                 " datasets of ice are stored for this area and time: the oldest are not asked");
      break;
    }
    if (is_areas_alone(dataset) && std::ranges::any_of(used, tells_of_departure)) break;
    const Validity valid{*period};
    if (!covers(valid.held, query.depart) && (named || !overlap(valid.held, mission))) {
      periods_missed +=
          (periods_missed.empty() ? "" : "; ") + title(dataset) + " covers " + period_text(*period);
      continue;
    }
    const std::vector<const Product*> before = covering(valid, mission, used);
    if (!before.empty() && looks_into_gaps++ >= most_looks_into_gaps) continue;
    const Period wanted{std::clamp(query.depart, period->from, period->to), period->to};
    auto ice = FieldRepository{draft.db, draft.reading.stop}.load_ice(dataset.id, query.area, wanted);
    if (!ice || (!before.empty() && !fills_a_gap(*ice, query.area, before))) continue;
    const bool reaches_all = reaches_all_of(query.area, ice->samples().grid);
    used.push_back(
        {dataset, *period, valid, reaches_all, std::make_shared<const ocean::IceField>(std::move(*ice))});
  }
  // Of ice that begins later alone nothing follows for the beginning of a mission, which may end before it.
  if (std::ranges::none_of(used, tells_of_departure)) {
    for (const Product& product : used)
      periods_missed += (periods_missed.empty() ? "" : "; ") + title(product.dataset) + " covers " +
                        period_text(product.period);
    used.clear();
  }

  if (!used.empty()) {
    adopt(draft, used);
    report(draft, used);
    if (is_areas_alone(used.front().dataset)) return;
    for (const Dataset& unused : areas)
      draft.warn(title(unused) + " holds areas of ice and nothing outside them; not used beside " +
                 title(used.front().dataset) + "; make zones of them, or name it to plan with it alone");
  } else if (named && !periods_missed.empty()) {
    draft.refuse(DatasetKind::ice, "says nothing of the ice at " + core::iso8601(query.depart) + ": " +
                                       periods_missed + ", and ice is held for at most 3 days beyond");
  } else if (named && !found.empty()) {
    draft.refuse(DatasetKind::ice, title(found.front()) + " has no node near the area");
  } else if (!periods_missed.empty()) {
    draft.warn("no stored ice for the time of departure (" + periods_missed + "): open water is assumed");
  } else if (!named) {
    warn_of_gap(draft, DatasetKind::ice, query.ice, "open water is assumed");
  }
}

}  // namespace floeplan::repository
