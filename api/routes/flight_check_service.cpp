#include "api/routes/flight_check_service.hpp"

#include <nlohmann/json.hpp>

#include "api/codec/plan_inputs.hpp"
#include "engine/mission/flight_check.hpp"
#include "storage/repository/environment_loader.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// The route as the evaluation of routes takes it, at least two places long, so that area and request follow.
json route_json(std::optional<geo::LonLat> start, const mission::FlightRoute& flight) {
  json route = json::array();
  if (start) route.push_back({start->lon_deg, start->lat_deg});
  for (const geo::LonLat place : flight.places()) route.push_back({place.lon_deg, place.lat_deg});
  if (route.size() == 1) route.push_back(route.front());
  return route;
}

}  // namespace

core::Violations check_flight(sqlite::Connection& db, json inputs, std::optional<geo::LonLat> start,
                              std::vector<mission::Document>& documents) {
  const mission::FlightRoute flight = mission::route_of(documents);
  if (flight.stops.empty()) {
    mission::check_flight(documents, {}, start, {});
    return {};
  }
  inputs["route"] = route_json(start, flight);
  auto parsed = codec::parse_evaluate_inputs(inputs);
  if (!parsed) return parsed.error();
  const auto environment = repository::load_environment(db, parsed->data);
  if (!environment) return environment.error();
  mission::check_flight(documents, *environment, start, parsed->request);
  return {};
}

}  // namespace floeplan::routes
