#include "api/codec/documents/surfacing_document.hpp"

#include <stdexcept>

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/store_messages.hpp"
#include "engine/planning/problem/objective.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json position(geo::LonLat place) {
  return json::array({document_degrees(place.lon_deg), document_degrees(place.lat_deg)});
}

json escape_json(const planning::EscapeWay& escape, std::size_t waypoint) {
  json way = json::array();
  for (const geo::LonLat place : escape.way) way.push_back(position(place));
  json propulsion = json::array();
  for (const vehicle::Drive drive : escape.drives) propulsion.push_back(planning::drive_name(drive));
  return {{"waypoint", waypoint},
          {"to", position(escape.way.back())},
          {"course_deg", escape.course_deg ? json(*escape.course_deg) : json()},
          {"distance_m", escape.distance.value},
          {"time_s", escape.time.count()},
          {"energy_j", escape.energy.value},
          {"way", std::move(way)},
          {"propulsion", std::move(propulsion)}};
}

planning::EscapeWay parse_escape(const json& object) {
  planning::EscapeWay escape;
  for (const json& place : object.at("way"))
    escape.way.push_back({place.at(0).get<double>(), place.at(1).get<double>()});
  for (const json& name : object.at("propulsion")) {
    const auto drive = planning::parse_drive(name.get<std::string>());
    if (!drive)
      throw std::runtime_error{messages::store_text<"stored-plan-unreadable">(
          "an escape route has a leg with an unknown propulsion")};
    escape.drives.push_back(*drive);
  }
  if (!object.at("course_deg").is_null()) escape.course_deg = object.at("course_deg").get<double>();
  escape.distance = {object.at("distance_m").get<double>()};
  escape.time = core::Seconds{object.at("time_s").get<double>()};
  escape.energy = {object.at("energy_j").get<double>()};
  return escape;
}

std::optional<core::Metres> stored_metres(const json& object, const char* key) {
  const json& metres = object.at(key);
  return metres.is_null() ? std::nullopt : std::optional{core::Metres{metres.get<double>()}};
}

planning::PlannedSurfacing parse_planned(const json& object) {
  return {.place = {object.at("lon").get<double>(), object.at("lat").get<double>()},
          .time = stored_time(object, "time"),
          .position_error = {object.at("position_error_m").get<double>()},
          .nearest_ice = stored_metres(object, "nearest_ice_m")};
}

json metres_or_null(const std::optional<core::Metres>& metres) {
  return metres ? json(metres->value) : json();
}

json below_ice_json(const std::optional<std::vector<planning::StretchBelowIce>>& stretches) {
  if (!stretches) return nullptr;
  json all = json::array();
  for (const planning::StretchBelowIce& stretch : *stretches) {
    all.push_back({{"waypoint", stretch.waypoint},
                   {"from", position(stretch.from)},
                   {"to", position(stretch.to)},
                   {"enters", core::iso8601(stretch.enters)},
                   {"time_s", stretch.time.count()},
                   {"distance_m", stretch.length.value}});
  }
  return all;
}

std::optional<std::vector<planning::StretchBelowIce>> parse_below_ice(const json& surfacing) {
  const json& stretches = surfacing.at("below_ice");
  if (stretches.is_null()) return std::nullopt;
  const auto place = [](const json& at) {
    return geo::LonLat{at.at(0).get<double>(), at.at(1).get<double>()};
  };
  std::vector<planning::StretchBelowIce> all;
  for (const json& stretch : stretches) {
    all.push_back({.waypoint = stretch.at("waypoint").get<std::size_t>(),
                   .from = place(stretch.at("from")),
                   .to = place(stretch.at("to")),
                   .enters = stored_time(stretch, "enters"),
                   .time = core::Seconds{stretch.at("time_s").get<double>()},
                   .length = {stretch.at("distance_m").get<double>()}});
  }
  return all;
}

planning::SurfacingState parse_state(const json& waypoint) {
  return {.may_surface = waypoint.at("may_surface").get<bool>(),
          .since_surfacing = core::Seconds{waypoint.at("since_last_surfacing_s").get<double>()},
          .position_error = {waypoint.at("position_error_m").get<double>()},
          .least_upper_turn = {waypoint.at("least_upper_turn_m").get<double>()},
          .leg_upper_turn = stored_metres(waypoint, "leg_upper_turn_m"),
          .ice_free_before = stored_metres(waypoint, "ice_free_before_m"),
          .error_without_fix = stored_metres(waypoint, "error_without_fix_m"),
          .nearest_ice = stored_metres(waypoint, "nearest_ice_m")};
}

}  // namespace

bool is_leg_below_ice(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint) {
  return plan && plan->waypoints.at(waypoint).leg_upper_turn.value_or(core::Metres{0.0}).value > 0.0;
}

void add_surfacing_state(const std::optional<planning::SurfacingPlan>& plan, std::size_t waypoint,
                         json& object) {
  const auto* state = plan ? &plan->waypoints.at(waypoint) : nullptr;
  object["may_surface"] = state != nullptr ? json(state->may_surface) : json();
  object["since_last_surfacing_s"] = state != nullptr ? json(state->since_surfacing.count()) : json();
  object["position_error_m"] = state != nullptr ? json(state->position_error.value) : json();
  object["least_upper_turn_m"] = state != nullptr ? json(state->least_upper_turn.value) : json();
  object["leg_upper_turn_m"] = state != nullptr ? metres_or_null(state->leg_upper_turn) : json();
  object["ice_free_before_m"] = state != nullptr ? metres_or_null(state->ice_free_before) : json();
  object["nearest_ice_m"] = state != nullptr ? metres_or_null(state->nearest_ice) : json();
  object["error_without_fix_m"] = state != nullptr ? metres_or_null(state->error_without_fix) : json();
}

json surfacing_json(const std::optional<planning::SurfacingPlan>& plan) {
  if (!plan) return nullptr;
  json surfacings = json::array();
  for (const auto& surfacing : plan->surfacings) {
    surfacings.push_back({{"lon", document_degrees(surfacing.place.lon_deg)},
                          {"lat", document_degrees(surfacing.place.lat_deg)},
                          {"time", core::iso8601(surfacing.time)},
                          {"position_error_m", surfacing.position_error.value},
                          {"nearest_ice_m", metres_or_null(surfacing.nearest_ice)}});
  }
  const auto below_s = planning::time_below_ice(*plan);
  json escapes = json::array();
  for (const auto& escape : plan->escapes) escapes.push_back(escape_json(escape, escapes.size()));
  return {{"longest_without_surfacing_s", plan->longest_without.count()},
          {"below_ice_m", metres_or_null(planning::length_below_ice(*plan))},
          {"below_ice_s", below_s ? json(below_s->count()) : json()},
          {"below_ice", below_ice_json(plan->below_ice)},
          {"unknown_ice_m", plan->unknown_ice.value},
          {"planned", std::move(surfacings)},
          {"escapes", std::move(escapes)}};
}

std::optional<planning::SurfacingPlan> parse_surfacing(const json& document) {
  const json& surfacing = document.at("surfacing");
  if (surfacing.is_null()) return std::nullopt;
  planning::SurfacingPlan plan;
  plan.longest_without = core::Seconds{surfacing.at("longest_without_surfacing_s").get<double>()};
  plan.unknown_ice = {surfacing.at("unknown_ice_m").get<double>()};
  for (const json& waypoint : document.at("waypoints")) plan.waypoints.push_back(parse_state(waypoint));
  for (const json& planned : surfacing.at("planned")) plan.surfacings.push_back(parse_planned(planned));
  for (const json& escape : surfacing.at("escapes")) plan.escapes.push_back(parse_escape(escape));
  plan.below_ice = parse_below_ice(surfacing);
  return plan;
}

}  // namespace floeplan::codec
