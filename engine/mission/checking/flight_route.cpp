#include "engine/mission/checking/flight_route.hpp"

#include <algorithm>
#include <iterator>

#include "engine/core/letter_case.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/mission/document/behavior_values.hpp"
#include "engine/mission/document/flown_rows.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/document/list_rules.hpp"

namespace floeplan::mission {
namespace {

bool has_route(const Document& document) {
  return document.verdict() != Verdict::reject && !document.waypoints.empty();
}

std::size_t closest_of(const std::vector<WaypointRow>& rows, geo::LonLat from) {
  const auto closest = std::ranges::min_element(
      rows, {}, [&](const WaypointRow& row) { return geo::geodesic_between(from, row.place).length.value; });
  return static_cast<std::size_t>(closest - rows.begin());
}

/// Number of places that a mission gives inline for a list, whatever their units.
std::size_t slots_of(const Behavior& list) {
  std::size_t slots = 0;
  while (list.find("wpt_x_" + std::to_string(slots)) != nullptr) ++slots;
  return slots;
}

/// Adds the rows of the list that are flown to the route.
void fly_list(const Behavior& list, const std::vector<WaypointRow>& rows, std::optional<geo::LonLat> from,
              FlownWaypoints& route) {
  if (rows.empty()) return;
  if (!route.rows.empty()) from = route.rows.back().place;
  const auto orders =
      list_orders(value_of(list, "num_legs_to_run"), value_of(list, "initial_wpt"), rows.size());
  if (!orders) {
    route.faults.push_back(orders.error());
    std::ranges::copy(rows, std::back_inserter(route.rows));
    return;
  }
  const FlownRows flown = flown_rows(*orders, rows.size(), from ? closest_of(rows, *from) : 0);
  for (const std::size_t row : flown.rows) route.rows.push_back(rows[row]);
  route.goes_round = flown.goes_round;
  if (auto note = note_of_rows(*orders, flown, rows.size(), from.has_value()); !note.empty())
    route.notes.push_back(std::move(note));
}

FlownWaypoints flown_of_mission(const Document& mission, std::optional<geo::LonLat> from) {
  FlownWaypoints route;
  for (const Behavior& behavior : mission.behaviors) {
    Messages told_already;
    const std::vector<WaypointRow> rows = inline_waypoints(behavior, told_already);
    if (rows.empty() && (slots_of(behavior) > 0 || behavior.find("wpt_x") != nullptr)) {
      route.notes.push_back(behavior.name + " at line " + std::to_string(behavior.line) +
                            " has its waypoints in local metres or UTM, which are left out");
    } else if (behavior.name == "goto_list" && slots_of(behavior) == rows.size()) {
      fly_list(behavior, rows, from, route);
    } else if (behavior.name == "goto_list" || behavior.name == "goto_wpt") {
      std::ranges::copy(rows, std::back_inserter(route.rows));
      if (behavior.name == "goto_list" && !rows.empty())
        route.notes.emplace_back(
            "the list has rows in local metres or UTM, which are left out; the others are taken once, in "
            "their "
            "order");
    }
  }
  return route;
}

}  // namespace

FlownWaypoints flown_waypoints(const Document& document, std::optional<geo::LonLat> from) {
  if (document.kind == DocumentKind::mission) return flown_of_mission(document, from);
  FlownWaypoints route;
  const bool is_list = document.kind == DocumentKind::arguments && document.behaviors.size() == 1 &&
                       document.behaviors.front().name == "goto_list";
  if (is_list) {
    fly_list(document.behaviors.front(), document.waypoints, from, route);
    if (const auto hold = hold_order(document)) route.notes = {hold_text(*hold)};
  } else {
    route.rows = document.waypoints;
    for (const Message& message : document.messages)
      if (message.code == "target_off_the_way" || message.code == "targets_go_round")
        route.notes.push_back(message.text);
  }
  return route;
}

std::vector<geo::LonLat> FlightRoute::places() const {
  std::vector<geo::LonLat> places;
  places.reserve(stops.size());
  for (const Stop& stop : stops) places.push_back(stop.place);
  return places;
}

bool is_recovery_list(const Document& document) {
  const std::string name = core::lower_case(document.name);
  return name == "goto_l98.ma" || name == "goto_l99.ma";
}

FlightRoute route_of(const std::vector<Document>& documents, std::optional<geo::LonLat> start) {
  const bool has_others = std::ranges::any_of(
      documents, [](const Document& document) { return has_route(document) && !is_recovery_list(document); });
  FlightRoute route;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const Document& document = documents[i];
    if (!has_route(document) || (has_others && is_recovery_list(document))) continue;
    const FlownWaypoints flown =
        flown_waypoints(document, route.stops.empty() ? start : route.stops.back().place);
    for (const WaypointRow& row : flown.rows) route.stops.push_back({row.place, i, row.line});
    if (flown.goes_round && flown.rows.size() > 2)
      route.stops.push_back({flown.rows.front().place, i, flown.rows.front().line});
  }
  return route;
}

}  // namespace floeplan::mission
