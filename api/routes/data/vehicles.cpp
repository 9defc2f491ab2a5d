
#include "api/codec/inputs/vehicle_inputs.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

Response list_vehicles(const Context&, const Request&, const PathParameters&) {
  nlohmann::json vehicles = nlohmann::json::array();
  for (const auto& profile : vehicle::known_profiles()) {
    vehicles.push_back(codec::vehicle_json(profile));
  }
  return json_reply({{"vehicles", vehicles}});
}

}  // namespace

std::vector<Route> vehicle_routes() { return {{"GET", "/vehicles", {}, list_vehicles}}; }

}  // namespace floeplan::routes
