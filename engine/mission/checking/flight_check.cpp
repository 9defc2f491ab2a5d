#include "engine/mission/checking/flight_check.hpp"

#include <algorithm>
#include <iterator>

#include "engine/core/letter_case.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/mission/checking/ice_check.hpp"
#include "engine/mission/checking/yo_flight.hpp"
#include "engine/mission/document/behavior_values.hpp"
#include "engine/mission/document/document_text.hpp"

namespace floeplan::mission {
namespace {

const Behavior* first_of(const Document& document, std::string_view name) {
  const auto found = std::ranges::find(document.behaviors, name, &Behavior::name);
  return found == document.behaviors.end() ? nullptr : &*found;
}

void check_files(Document& mission, const std::vector<Document>& documents) {
  for (const std::string& name : files_referenced(mission)) {
    const bool there = std::ranges::any_of(
        documents, [&](const Document& document) { return core::lower_case(document.name) == name; });
    if (!there) report(mission, 0, messages::mission_check_message<"file_missing">(name));
  }
}

/// Checks that a mission controls both pitch and heading: a list without a yo, or a yo without a list, leaves
/// one of them open.
void check_commands(Document& mission) {
  const bool steers =
      first_of(mission, "goto_list") || first_of(mission, "goto_wpt") || first_of(mission, "set_heading");
  const bool dives =
      first_of(mission, "yo") || first_of(mission, "drift_at_depth") || first_of(mission, "dive_to");
  if (steers && !dives) report(mission, 0, messages::mission_check_message<"nothing_dives">());
  if (dives && !steers) report(mission, 0, messages::mission_check_message<"nothing_steers">());
}

void check_overdepth(Document& mission, const std::optional<DiveArguments>& dive) {
  const Behavior* abend = first_of(mission, "abend");
  if (abend == nullptr) {
    if (!mission.behaviors.empty()) report(mission, 0, messages::mission_check_message<"no_abend_to_fly">());
    return;
  }
  const auto limit = value_of(*abend, "overdepth");
  if (!dive || !limit || *limit < 0.0 || dive->target_depth.value < *limit) return;
  report(mission, abend->line,
         messages::mission_check_message<"target_below_overdepth">(dive->target_depth.value));
}

void check_distances(Document& mission, const std::vector<geo::LonLat>& places) {
  const Behavior* abend = first_of(mission, "abend");
  const auto limit_m = abend == nullptr ? std::nullopt : value_of(*abend, "max_wpt_distance");
  if (!limit_m || *limit_m < 0.0) return;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double leg_m = geo::geodesic_between(places[i - 1], places[i]).length.value;
    if (leg_m <= *limit_m) continue;
    report(mission, abend->line, messages::mission_check_message<"waypoint_too_far">(i, leg_m));
    return;
  }
}

std::vector<geo::LonLat> with_start(std::optional<geo::LonLat> start, const FlightRoute& route) {
  std::vector<geo::LonLat> places = route.places();
  if (start) places.insert(places.begin(), *start);
  return places;
}

void note_timing(Document& document, const planning::Plan& timing) {
  report(document, 0,
         messages::mission_check_message<"route_clear">(timing.distance.value / 1000.0,
                                                        timing.travel_time().count() / 3600.0,
                                                        timing.departure, timing.arrival));
}

/// Adds notes to recovery lists that are left out of the route.
void note_recovery_lists(std::vector<Document>& documents, const FlightRoute& route) {
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const bool is_flown =
        std::ranges::find(route.stops, i, &FlightRoute::Stop::document) != route.stops.end();
    if (!is_flown && is_recovery_list(documents[i]))
      report(documents[i], 0, messages::mission_check_message<"recovery_list">());
  }
}

/// Warns about the basis of the result: missing or extrapolated data, or a battery that does not suffice.
void warn_of_grounds(Document& document, const std::vector<messages::Message>& grounds) {
  for (const std::string& ground : messages::sentences(grounds))
    report(document, 0, messages::mission_check_message<"sea_data">(ground));
}

void check_mission(Document& mission, const std::vector<Document>& documents,
                   const std::optional<DiveArguments>& dive, const std::vector<geo::LonLat>& places) {
  check_files(mission, documents);
  check_commands(mission);
  check_overdepth(mission, dive);
  check_distances(mission, places);
}

void check_sea(std::vector<Document>& documents, const ocean::Environment& environment,
               const FlightRoute& route, std::optional<geo::LonLat> start,
               const std::optional<DiveArguments>& dive, planning::PlanRequest request) {
  const std::vector<geo::LonLat> places = with_start(start, route);
  if (dive) request = flown_with(std::move(request), {dive->climb_to, dive->target_depth, dive->on_thruster});
  Document& first = documents[route.stops.front().document];
  if (places.size() < 2) {
    return report(first, route.stops.front().line, messages::mission_check_message<"no_leg">());
  }
  RouteCheck check = check_route(environment, places, request);
  if (dive) std::ranges::move(check_depths(environment, places, *dive), std::back_inserter(check.findings));

  const std::size_t before_first = start ? 1 : 0;
  for (const RouteFinding& finding : check.findings) {
    const auto& stop = route.stops[finding.place < before_first ? 0 : finding.place - before_first];
    documents[stop.document].messages.push_back(
        {stop.line, finding.dangerous ? Severity::error : Severity::warning, finding.code, finding.text});
  }
  warn_of_grounds(first, check.timing ? check.timing->messages : environment.messages);
  if (!check.timing) return;
  TimedRoute timed{*check.timing, {}};
  for (const std::size_t place : check.places) {
    timed.rows.push_back(place < before_first ? std::nullopt
                                              : std::optional{route.stops[place - before_first]});
  }
  const bool is_clear = check_below_ice(documents, timed, dive);
  if (check.findings.empty() && is_clear) note_timing(first, *check.timing);
}

}  // namespace

std::optional<DiveArguments> dive_of(const std::vector<Document>& documents) {
  for (const Document& document : documents) {
    const Behavior* yo = document.verdict() == Verdict::reject ? nullptr : first_of(document, "yo");
    if (yo == nullptr || reads_file(*yo)) continue;
    const auto depth = value_of(*yo, "d_target_depth");
    const auto altitude = value_of(*yo, "d_target_altitude");
    const auto climb = value_of(*yo, "c_target_depth");
    if (!depth) continue;
    const bool down = value_of(*yo, "d_use_thruster").value_or(0.0) > 0.0;
    const bool up = value_of(*yo, "c_use_thruster").value_or(0.0) > 0.0;
    return DiveArguments{.target_depth = core::Metres{*depth},
                         .altimeter = !altitude || *altitude >= 0.0,
                         .altitude = core::Metres{std::max(0.0, altitude.value_or(0.0))},
                         .climb_to = core::Metres{climb.value_or(0.0)},
                         .on_thruster = down && up};
  }
  return std::nullopt;
}

void check_flight(std::vector<Document>& documents, const ocean::Environment& environment,
                  std::optional<geo::LonLat> start, planning::PlanRequest request) {
  const FlightRoute route = route_of(documents, start);
  const auto dive = dive_of(documents);
  note_recovery_lists(documents, route);
  if (!route.stops.empty()) check_sea(documents, environment, route, start, dive, std::move(request));
  for (Document& document : documents) {
    if (document.kind == DocumentKind::mission && !document.lines.empty())
      check_mission(document, documents, dive, with_start(start, route));
    std::ranges::stable_sort(document.messages, {}, &Message::line);
  }
}

}  // namespace floeplan::mission
