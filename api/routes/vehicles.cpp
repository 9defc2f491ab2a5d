#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::routes {
namespace {

Response list_vehicles(const Context&, const Request&, const PathParameters&) {
  nlohmann::json vehicles = nlohmann::json::array();
  for (const auto& profile : vehicle::known_profiles()) {
    vehicles.push_back({{"name", profile.name},
                        {"title", profile.title},
                        {"speed_through_water_m_s", profile.speed_through_water.value},
                        {"dive_depth_m", profile.dive_depth.value},
                        {"depth_rating_m", profile.depth_rating.value},
                        {"minimum_working_depth_m", profile.minimum_working_depth.value},
                        {"max_waypoints_per_list", profile.max_waypoints_per_list}});
  }
  return json_reply({{"vehicles", vehicles}});
}

}  // namespace

std::vector<Route> vehicle_routes() { return {{"GET", "/vehicles", {}, list_vehicles}}; }

}  // namespace floeplan::routes
