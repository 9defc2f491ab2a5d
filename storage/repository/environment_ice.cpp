#include "storage/repository/environment_ice.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "engine/core/utc_text.hpp"

namespace floeplan::repository {
namespace {

/// No mission that is planned at once lasts longer.
constexpr core::Seconds longest_mission{30.0 * 86400.0};
/// More than one a day of such a mission.
constexpr std::size_t most_products = 40;

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
};

bool reaches_all_of(const geo::BoundingBox& area, const ocean::HorizontalGrid& grid) {
  constexpr int pieces = 16;
  const double width_deg = geo::width_deg(area);
  for (int row = 0; row <= pieces; ++row) {
    for (int column = 0; column <= pieces; ++column) {
      const double lat_deg = area.south_deg + (area.north_deg - area.south_deg) * row / pieces;
      const double lon_deg = geo::wrap_longitude(area.west_deg + width_deg * column / pieces);
      if (!grid.locate({lon_deg, lat_deg})) return false;
    }
  }
  return true;
}

/// Whether those before it tell all that data with this validity could.
bool is_hidden(const Validity& valid, const Period& mission, const std::vector<Product>& before) {
  const auto speaks = overlap(valid.speaks, mission);
  const auto held = overlap(valid.held, mission);
  return std::ranges::any_of(before, [&](const Product& product) {
    if (!product.reaches_all_of_the_area) return false;
    return speaks ? is_within(*speaks, product.valid.speaks) : is_within(*held, product.valid.held);
  });
}

void warn_of_what_is_held(EnvironmentDraft& draft, const std::vector<Product>& used) {
  const core::UtcTime depart = draft.query.depart;
  const auto speaks = [&](const Product& product) { return covers(product.valid.speaks, depart); };
  const auto is_held = [&](const Product& product) { return covers(product.valid.held, depart); };
  const auto spoken = std::ranges::find_if(used, speaks);
  const auto now = spoken != used.end() ? spoken : std::ranges::find_if(used, is_held);
  if (now == used.end()) {
    draft.warn("nothing is stored of the ice at the time of departure, only of that of " +
               period_text(used.front().period) +
               ": until it is known open water is assumed, above the keels " + "of its first step");
    return;
  }
  if (covers(now->period, depart)) return;
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

void adopt(EnvironmentDraft& draft, const Dataset& dataset, ocean::IceField ice) {
  if (ice.samples().thickness_m.empty())
    draft.warn("ice of " + title(dataset) + " has no thickness: a draft is assumed wherever there is ice");
  auto field = std::make_shared<const ocean::IceField>(std::move(ice));
  if (!draft.environment.ice) {
    draft.environment.ice = std::move(field);
  } else {
    draft.environment.further_ice.push_back(std::move(field));
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
  std::string periods_missed;
  std::vector<Product> used;
  for (const Dataset& dataset : found) {
    const auto period = period_of(dataset);
    if (!period || used.size() == most_products) continue;
    if (is_areas_alone(dataset) && !used.empty()) break;
    const Validity valid{*period};
    if (!covers(valid.held, query.depart) && (named || !overlap(valid.held, mission))) {
      periods_missed +=
          (periods_missed.empty() ? "" : "; ") + title(dataset) + " covers " + period_text(*period);
      continue;
    }
    if (is_hidden(valid, mission, used)) continue;
    const Period wanted{std::clamp(query.depart, period->from, period->to), period->to};
    auto ice = FieldRepository{draft.db, draft.reading.stop}.load_ice(dataset.id, query.area, wanted);
    if (!ice) continue;
    used.push_back({dataset, *period, valid, reaches_all_of(query.area, ice->samples().grid)});
    adopt(draft, dataset, std::move(*ice));
  }

  if (!used.empty()) {
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
