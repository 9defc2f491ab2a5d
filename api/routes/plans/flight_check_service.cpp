#include "api/routes/plans/flight_check_service.hpp"

#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/mission/checking/flight_check.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// The route from where the vehicle is, at least two places long, so that area and request follow.
std::vector<geo::LonLat> whole_route(std::optional<geo::LonLat> start, const mission::FlightRoute& flight) {
  std::vector<geo::LonLat> route = flight.places();
  if (start) route.insert(route.begin(), *start);
  if (route.size() == 1) route.push_back(route.front());
  return route;
}

}  // namespace

core::Violations check_flight(sql::Connection& db, const json& inputs, std::optional<geo::LonLat> start,
                              std::vector<mission::Document>& documents) {
  const mission::FlightRoute flight = mission::route_of(documents, start);
  if (flight.stops.empty()) {
    mission::check_flight(documents, {}, start, {});
    return {};
  }
  auto parsed = codec::parse_flight_inputs(inputs, whole_route(start, flight));
  if (!parsed) return parsed.error();
  const auto environment = repository::load_environment(db, parsed->data);
  if (!environment) return environment.error();
  mission::check_flight(documents, *environment, start, parsed->request);
  return {};
}

}  // namespace floeplan::routes
