#include "api/codec/features/plan_feature.hpp"

#include <stdexcept>

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/features/line_geometry.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/store_messages.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

namespace {

geo::LonLat waypoint_place(const json& waypoint) {
  return {waypoint.at("lon").get<double>(), waypoint.at("lat").get<double>()};
}

core::UtcTime time_of(const json& waypoint) {
  const auto time = core::parse_iso8601(waypoint.at("eta").get<std::string>());
  if (!time)
    throw std::runtime_error{messages::store_text<"stored-plan-unreadable">("a waypoint has no valid time")};
  return *time;
}

json number_or_null(const json& object, const char* key) { return object.value(key, json()); }

json part_feature(const repository::PlanRecord& plan, std::size_t index, json geometry, json properties) {
  properties["plan_id"] = plan.id.value;
  properties["plan_name"] = plan.name;
  properties["index"] = index;
  return {{"type", "Feature"},
          {"id", plan.id.value + "." + std::to_string(index)},
          {"geometry", std::move(geometry)},
          {"properties", std::move(properties)}};
}

}  // namespace

json plan_feature(const repository::PlanRecord& plan) {
  json document = json::parse(plan.document_json);
  json geometry = line_geometry(route_of(document));
  document["name"] = plan.name;
  document["created"] = core::iso8601(plan.created);
  return {{"type", "Feature"},
          {"id", plan.id.value},
          {"geometry", std::move(geometry)},
          {"properties", std::move(document)}};
}

std::vector<PlanPart> plan_legs(const repository::PlanRecord& plan) {
  const json document = json::parse(plan.document_json);
  const json& waypoints = document.at("waypoints");
  std::vector<PlanPart> legs;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const json& tail = waypoints[i - 1];
    const json& head = waypoints[i];
    const std::vector<geo::LonLat> ends{waypoint_place(tail), waypoint_place(head)};
    const double waited_s = tail.value("wait_s", 0.0);
    const core::UtcTime begin = time_of(tail) + core::Seconds{waited_s};
    json properties{{"depart", core::iso8601(begin)},
                    {"arrive", head.at("eta")},
                    {"length_m", number_or_null(head, "leg_m")},
                    {"course_deg", number_or_null(head, "course_deg")},
                    {"speed_over_ground_m_s", number_or_null(head, "speed_over_ground_m_s")},
                    {"iceberg_encounters", number_or_null(head, "iceberg_encounters")},
                    {"energy_j", number_or_null(head, "energy_j")},
                    {"propulsion", number_or_null(head, "propulsion")}};
    legs.push_back({part_feature(plan, i - 1, line_geometry(ends), std::move(properties)), begin,
                    time_of(head), geo::bounding_box(ends)});
  }
  return legs;
}

std::vector<PlanPart> plan_waypoints(const repository::PlanRecord& plan) {
  const json document = json::parse(plan.document_json);
  std::vector<PlanPart> places;
  for (const json& waypoint : document.at("waypoints")) {
    const geo::LonLat place = waypoint_place(waypoint);
    const core::UtcTime time = time_of(waypoint);
    const double waited_s = waypoint.value("wait_s", 0.0);
    json properties{{"eta", waypoint.at("eta")},
                    {"wait_s", waited_s},
                    {"depth_m", number_or_null(waypoint, "depth_m")},
                    {"energy_j", number_or_null(waypoint, "energy_j")}};
    json geometry{{"type", "Point"}, {"coordinates", json::array({place.lon_deg, place.lat_deg})}};
    places.push_back({part_feature(plan, places.size(), std::move(geometry), std::move(properties)),
                      time,
                      time + core::Seconds{waited_s},
                      {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}});
  }
  return places;
}

}  // namespace floeplan::codec
