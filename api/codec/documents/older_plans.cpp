#include "api/codec/documents/older_plans.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

// Members of plan documents that the first version did not have, and the value that they get in a plan without
// them. A new member of plan documents gets a row here.
const json later_in_plan{
    {"energy", nullptr},          {"encounter_trade", nullptr},    {"iceberg_encounters", nullptr},
    {"leg_trade", json::array()}, {"passed_under", json::array()}, {"refinement", nullptr},
    {"surfacing", nullptr},       {"uncertainty", nullptr},        {"via_order", nullptr}};
const json later_in_search{{"cut_short", false}, {"possible_gain_s", nullptr}};
const json later_in_waypoint{{"current_east_m_s", nullptr},
                             {"current_north_m_s", nullptr},
                             {"energy_j", nullptr},
                             {"error_without_fix_m", nullptr},
                             {"ice_free_before_m", nullptr},
                             {"iceberg_encounters", nullptr},
                             {"leg_upper_turn_m", nullptr},
                             {"nearest_ice_m", nullptr},
                             {"propulsion", nullptr},
                             {"speed_through_water_m_s", nullptr},
                             {"wait_s", 0.0}};
const json later_in_clearances{{"iceberg_id", nullptr}};
const json later_in_surfacing{{"below_ice", nullptr}, {"below_ice_m", nullptr}, {"below_ice_s", nullptr}};
const json later_in_planned{{"nearest_ice_m", nullptr}};
const json later_in_escape{{"energy_j", 0.0}, {"propulsion", json::array()}};

void complete(json& object, const json& later) {
  for (const auto& [name, value] : later.items()) object.emplace(name, value);  // unless it is there
}

}  // namespace

json with_later_members(json document) {
  complete(document, later_in_plan);
  complete(document.at("search"), later_in_search);
  complete(document.at("clearances"), later_in_clearances);
  for (json& waypoint : document.at("waypoints")) complete(waypoint, later_in_waypoint);
  json& surfacing = document.at("surfacing");
  if (surfacing.is_null()) return document;
  complete(surfacing, later_in_surfacing);
  for (json& planned : surfacing.at("planned")) complete(planned, later_in_planned);
  for (json& escape : surfacing.at("escapes")) complete(escape, later_in_escape);
  return document;
}

}  // namespace floeplan::codec
