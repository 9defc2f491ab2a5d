#include "api/service/flight_check_service.hpp"

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/service/export_sea.hpp"
#include "engine/messages/fault.hpp"
#include "engine/mission/checking/flight_check.hpp"
#include "engine/mission/checking/plan_comparison.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;

/// The route from the vehicle's position, with at least two positions, because area and request need these.
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

core::Violations compare_with_plan(sql::Connection& db, const std::string& plan_id,
                                   std::vector<mission::Document>& documents) {
  const auto record = repository::PlanRepository{db}.find({plan_id});
  if (!record) return {messages::fault<"no-such-plan">("/plan_id", plan_id)};
  const planning::Plan plan = codec::parse_plan_document(json::parse(record->document_json));
  mission::HoldOptions holds = holds_of(db, *record, plan);
  if (const auto inputs = inputs_of(*record))
    holds.between_surfacings = inputs->request.under_ice.surfacing_interval.value_or(
        mission::usual_surfacing_interval(holds.vehicle));
  mission::compare_with_plan(documents, plan, holds);
  return {};
}

}  // namespace floeplan::service
