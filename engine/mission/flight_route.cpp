#include "engine/mission/flight_route.hpp"

#include <algorithm>
#include <optional>

#include "engine/core/letter_case.hpp"
#include "engine/mission/behavior_values.hpp"

namespace floeplan::mission {
namespace {

bool has_route(const Document& document) {
  return document.verdict() != Verdict::reject && !document.waypoints.empty();
}

}  // namespace

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

FlightRoute route_of(const std::vector<Document>& documents) {
  const bool has_others = std::ranges::any_of(
      documents, [](const Document& document) { return has_route(document) && !is_recovery_list(document); });
  FlightRoute route;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const Document& document = documents[i];
    if (!has_route(document) || (has_others && is_recovery_list(document))) continue;
    const bool list = document.kind == DocumentKind::arguments;
    for (const WaypointRow& row : document.waypoints) route.stops.push_back({row.place, i, row.line});
    const auto legs = list ? value_of(document.behaviors.front(), "num_legs_to_run") : std::nullopt;
    if (legs == -1.0 && document.waypoints.size() > 2)
      route.stops.push_back({document.waypoints.front().place, i, document.waypoints.front().line});
  }
  return route;
}

}  // namespace floeplan::mission
