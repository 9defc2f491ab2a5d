#include "storage/repository/environment/environment_loader.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/data_messages.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_draft.hpp"
#include "storage/repository/environment/environment_parts.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/known_icebergs.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/sql/snapshot.hpp"

namespace floeplan::repository {
namespace {

/// Warns of bergs that were seen too long ago: they may still be there, but the plan does not avoid them.
void tell_of_old_sightings(EnvironmentDraft& draft, const KnownIcebergs& known) {
  std::vector<std::string> dropped;
  std::vector<std::string> lists;
  for (const Dataset& dataset : known.consulted) {
    const auto before = dropped.size();
    for (const StoredSighting& sighting : known.too_old)
      if (sighting.dataset == dataset.id)
        dropped.push_back(sighting.iceberg.id.empty() ? "one without a name" : sighting.iceberg.id);
    if (dropped.size() == before) continue;
    lists.push_back(title(dataset));
  }
  if (dropped.empty()) return;
  const core::UtcTime oldest = ocean::oldest_that_counts(sightings_as_of(draft.query), draft.query.depart,
                                                         ocean::largest_sighting_age);
  const bool can_count = std::ranges::any_of(
      known.too_old, [&](const StoredSighting& sighting) { return sighting.iceberg.observed >= oldest; });
  const std::string in = core::shortened_list(lists);
  const std::string names = core::shortened_list(dropped);
  draft.tell(can_count ? messages::data_message<"sightings-too-old">(
                             dropped.size(), known.bergs(), known.sightings.size(), in, known.oldest, names)
                       : messages::data_message<"sightings-too-old-for-any-plan">(
                             dropped.size(), known.bergs(), known.sightings.size(), in, known.oldest, names));
}

/// Warns of bergs whose first sighting is later than the time up to which sightings count: they may have been
/// there before, but the plan does not avoid them. If the user set that time, this is intended.
void tell_of_later_sightings(EnvironmentDraft& draft, const KnownIcebergs& known) {
  if (known.later.empty()) return;
  const core::UtcTime as_of = sightings_as_of(draft.query);
  std::vector<std::string> dropped;
  core::UtcTime last = as_of;
  for (const StoredSighting& sighting : known.later) {
    const ocean::Iceberg& berg = sighting.iceberg;
    dropped.push_back((berg.id.empty() ? "one without a name" : berg.id) + " at " +
                      core::iso8601(berg.observed));
    last = std::max(last, berg.observed);
  }
  const std::string names = core::shortened_list(dropped);
  const std::size_t used = known.sightings.size();
  if (draft.query.icebergs_as_of)
    return draft.tell(
        messages::data_message<"sightings-left-out">(dropped.size(), known.bergs(), used, as_of, names));
  const core::UtcTime let_count = std::chrono::ceil<std::chrono::seconds>(last);
  draft.tell(as_of > draft.query.depart ? messages::data_message<"sightings-after-window">(
                                              dropped.size(), known.bergs(), used, as_of, let_count, names)
                                        : messages::data_message<"sightings-after-departure">(
                                              dropped.size(), known.bergs(), used, as_of, let_count, names));
}

/// Lists the datasets with sightings, the named ones and the reports by hand; if there are none, the newest
/// that intersects the area.
void cite_sightings(EnvironmentDraft& draft, const KnownIcebergs& known) {
  const bool named = draft.query.icebergs.how == DatasetChoice::How::named;
  const bool nothing = known.sightings.empty() && known.too_old.empty();
  std::string joined;
  for (const Dataset& dataset : known.consulted) {
    const auto count = std::ranges::count(known.sightings, dataset.id, &StoredSighting::dataset) +
                       std::ranges::count(known.too_old, dataset.id, &StoredSighting::dataset);
    const bool is_here = known.speaks_here(dataset.id);
    const bool stands_for_the_area = nothing && draft.environment.datasets.empty() && is_here;
    const bool reported = is_here && dataset.id == hand_made_id(DatasetKind::icebergs);
    if (!named && !reported && count == 0 && !stands_for_the_area) continue;
    draft.cite(dataset);
    joined += (joined.empty() ? "" : ", ") + std::to_string(count) + " of " + title(dataset);
  }
  if (draft.environment.datasets.size() > 1) draft.tell(messages::data_message<"icebergs-joined">(joined));
}

/// Adds the icebergs. If the departure is not fixed and the query names no time for the sightings, sightings
/// up to the end of the period to cover (`until`) are used. Their age is measured at the earliest departure.
void add_icebergs(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  const core::UtcTime as_of = sightings_as_of(query);
  SightingQuery wanted{.choice = query.icebergs,
                       .area = query.area,
                       .as_of = as_of,
                       .depart = query.depart,
                       .max_age = query.max_sighting_age,
                       .also_left_out = true};
  if (query.iceberg_drift) {
    wanted.reach = reach_of_drift;
    wanted.track_age = query.max_sighting_age;
  }

  const KnownIcebergs known = known_icebergs(draft.db, draft.stored, wanted, draft.violations);
  const bool departure_decides = !query.icebergs_as_of && as_of > query.depart;
  for (const StoredSighting& sighting : known.sightings) {
    ocean::Iceberg& iceberg = draft.environment.icebergs.emplace_back(sighting.iceberg);
    if (departure_decides)
      iceberg.too_old_from = ocean::too_old_from(iceberg.observed, query.max_sighting_age);
  }
  tell_of_old_sightings(draft, known);
  tell_of_later_sightings(draft, known);
  cite_sightings(draft, known);
  if (draft.environment.datasets.empty() && known.later.empty() &&
      query.icebergs.how != DatasetChoice::How::named) {
    tell_of_gap(draft, query.icebergs, messages::data_message<"icebergs-left-out">(),
                messages::data_message<"icebergs-missing">(geo::bounds_text(named_area(query))));
  }
}

void add_coastline(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  auto chosen =
      candidates(draft.stored, DatasetKind::coastline, query.coastline, query.area, draft.violations);
  if (query.coastline.how == DatasetChoice::How::newest) keep_newest_coastline(chosen);

  for (const Dataset& dataset : chosen) {
    auto land = CoastlineRepository{draft.db}.load(dataset.id, query.area);
    std::ranges::move(land, std::back_inserter(draft.environment.land));
    draft.cite(dataset);
  }
  if (chosen.empty() && query.coastline.how != DatasetChoice::How::named) {
    tell_of_gap(draft, query.coastline, messages::data_message<"coastline-left-out">(),
                messages::data_message<"coastline-missing">(geo::bounds_text(named_area(query))));
  }
}

/// Warns of icebergs on land. They are avoided like any other, but their position must be wrong.
void tell_of_icebergs_on_land(EnvironmentDraft& draft) {
  const std::vector<ocean::Iceberg>& icebergs = draft.environment.icebergs;
  std::vector<geo::LonLat> places;
  for (const ocean::Iceberg& berg : icebergs) places.push_back(berg.place);
  const std::vector<bool> on_land = geo::contained_in_any(draft.environment.land, places);
  const auto first = std::ranges::find(on_land, true);
  if (first == on_land.end()) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < on_land.size(); ++i)
    if (on_land[i]) names.push_back(icebergs[i].id);
  draft.tell(messages::data_message<"icebergs-on-land">(names.size(), core::shortened_list(names))
                 .at(places[static_cast<std::size_t>(first - on_land.begin())]));
}

std::size_t corners_of(const ocean::Zone& zone) {
  std::size_t corners = zone.area.outer.size();
  for (const geo::Ring& hole : zone.area.holes) corners += hole.size();
  return corners;
}

void add_wind(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  const auto found = candidates(draft.stored, DatasetKind::wind, query.wind, query.area, draft.violations);
  const bool named = query.wind.how == DatasetChoice::How::named;
  if (named && query.wind.ids.size() > 1) {
    draft.refuse<"several-datasets">(DatasetKind::wind);
    return;
  }
  const bool moves_something = query.iceberg_drift && !draft.environment.icebergs.empty();
  if (!named && !moves_something) return;

  std::string periods_missed;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto parts = joined_parts(draft, found, i, named);
    const auto period = joined_period(found[i], parts);
    if (!period) continue;
    if (parts.empty() || !covers_begin(*period, query)) {
      periods_missed += (periods_missed.empty() ? "" : "; ") + coverage_text(found[i], *period);
      continue;
    }
    auto wind =
        read_joined(draft, parts, {geo::grown(query.area, reach_of_drift), std::nullopt}, drift_start(draft));
    if (!wind) continue;
    draft.environment.wind = std::move(wind);
    cite_joined(draft, parts);
    return;
  }

  if (named && !periods_missed.empty()) {
    draft.refuse<"no-wind-then">(DatasetKind::wind, query.depart, periods_missed);
  } else if (named && !found.empty()) {
    draft.refuse<"no-node-near">(DatasetKind::wind, title(found.front()));
  } else if (!periods_missed.empty()) {
    draft.tell(messages::data_message<"wind-not-at-departure">(periods_missed));
  }
}

/// Reports the zones of the area that are not used, because the plan does not show them otherwise.
void tell_of_zones_left_out(EnvironmentDraft& draft) {
  const DatasetChoice all;
  for (const Dataset& dataset :
       candidates(draft.stored, DatasetKind::zones, all, draft.query.area, draft.violations)) {
    const bool named = std::ranges::find(draft.query.zones.ids, dataset.id) != draft.query.zones.ids.end();
    if (!named) draft.tell(messages::data_message<"zones-left-out">(title(dataset)));
  }
}

void add_zones(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  std::size_t corners = 0;
  for (const Dataset& dataset :
       candidates(draft.stored, DatasetKind::zones, query.zones, query.area, draft.violations)) {
    for (ocean::Zone& zone : ZoneRepository{draft.db}.load(dataset.id, query.area, query.depart)) {
      corners += corners_of(zone);
      draft.environment.zones.push_back(std::move(zone));
    }
    draft.cite(dataset);
  }
  if (corners > max_zone_corners) {
    draft.refuse<"too-many-zone-corners">(DatasetKind::zones, corners, max_zone_corners);
  }
  if (query.zones.how != DatasetChoice::How::newest) tell_of_zones_left_out(draft);
}

}  // namespace

geo::BoundingBox named_area(const EnvironmentQuery& query) { return query.around_stops.value_or(query.area); }

core::UtcTime sightings_as_of(const EnvironmentQuery& query) {
  const core::UtcTime last_moment = query.may_begin_later && query.until ? query.until->time : query.depart;
  return query.icebergs_as_of.value_or(last_moment);
}

tl::expected<ocean::Environment, core::Violations> load_environment(sql::Connection& db,
                                                                    const EnvironmentQuery& query,
                                                                    const Reading& reading) {
  const sql::Snapshot snapshot{db};
  EnvironmentDraft draft{.db = db,
                         .query = query,
                         .reading = reading,
                         .stored = DatasetRepository{db}.list(),
                         .environment = {},
                         .violations = {}};
  // Icebergs first: the oldest sighting decides from when currents are needed. In the report they come after
  // the depths.
  EnvironmentDraft icebergs = draft;
  add_icebergs(icebergs);
  draft.environment.icebergs = std::move(icebergs.environment.icebergs);
  for (const auto& add : {add_water, add_wind, add_bathymetry, add_ice}) {
    if (reading.stop.stop_requested()) return std::move(draft.environment);
    add(draft);
  }
  tell_of_unknown_drift(draft);
  draft.append_report(icebergs);
  add_coastline(draft);
  tell_of_icebergs_on_land(draft);
  add_zones(draft);
  if (!draft.violations.empty()) return tl::unexpected(std::move(draft.violations));
  return std::move(draft.environment);
}

}  // namespace floeplan::repository
