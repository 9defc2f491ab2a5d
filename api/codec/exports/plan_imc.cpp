#include <algorithm>
#include <cmath>

#include "api/codec/exports/plan_files.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/mission/document/comment_text.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::ordered_json;

constexpr int depth_units = 1;        // ZUnits: depth
constexpr int metres_per_second = 0;  // SpeedUnits
constexpr int nobody = 65535;         // as source and destination: no addressee
constexpr int any_entity = 255;
constexpr int any_attitude = -1;                 // roll, pitch and yaw are left to the vehicle
constexpr double longest_hold_s = 65'535.0;      // largest duration of StationKeeping, 16 bits
constexpr double longest_part_s = 8.0 * 3600.0;  // half of the longest timeout, with a margin

/// Part of a leg: its end and its duration.
struct Part {
  geo::LonLat to;
  double duration_s{};
};

std::vector<Part> parts_of(const planning::Waypoint& from, const planning::Waypoint& to) {
  const double duration_s = (to.eta - (from.eta + from.wait)).count();
  const auto count = std::max(1.0, std::ceil(duration_s / longest_part_s));
  const geo::GeodesicLine leg = geo::geodesic_between(from.place, to.place);
  std::vector<Part> parts;
  for (double i = 1.0; i < count; i += 1.0) {
    const core::Metres along{leg.length.value * i / count};
    parts.push_back({geo::geodesic_destination(from.place, leg.course_at_start, along), duration_s / count});
  }
  parts.push_back({to.place, duration_s / count});
  return parts;
}

/// Depth of the dives on the leg to this waypoint, metres, as far as the shoalest place allows.
double depth_of(const planning::Plan& plan, std::size_t waypoint, const vehicle::GliderProfile& vehicle,
                const std::vector<std::optional<mission::Shoal>>& shoals) {
  double depth_m = vehicle.dive_depth.value;
  const auto keep_above = [&](core::Metres bed) {
    depth_m = std::min(depth_m, bed.value - vehicle.altimeter_margin.value);
  };
  for (const std::size_t end : {waypoint - 1, waypoint})
    if (const auto bed = plan.waypoints[end].depth) keep_above(*bed);
  if (waypoint < shoals.size() && shoals[waypoint]) keep_above(shoals[waypoint]->bed);
  return std::floor(std::max(depth_m, 0.0));
}

ordered_json go_to(const Part& part, double depth_m, double speed_m_s) {
  return {{"abbrev", "Goto"},
          {"timeout", static_cast<int>(std::ceil(2.0 * part.duration_s)) + 60},
          {"lat", core::degrees_to_radians(part.to.lat_deg)},
          {"lon", core::degrees_to_radians(geo::wrap_longitude(part.to.lon_deg))},
          {"z", depth_m},
          {"z_units", depth_units},
          {"speed", speed_m_s},
          {"speed_units", metres_per_second},
          {"roll", any_attitude},
          {"pitch", any_attitude},
          {"yaw", any_attitude},
          {"custom", ""}};
}

ordered_json keep_station(geo::LonLat place, double duration_s, double depth_m, double speed_m_s,
                          core::Metres radius) {
  return {{"abbrev", "StationKeeping"},
          {"lat", core::degrees_to_radians(place.lat_deg)},
          {"lon", core::degrees_to_radians(geo::wrap_longitude(place.lon_deg))},
          {"z", depth_m},
          {"z_units", depth_units},
          {"radius", radius.value},
          {"duration", std::lround(duration_s)},
          {"speed", speed_m_s},
          {"speed_units", metres_per_second},
          {"custom", ""}};
}

/// The list of maneuvers, with transitions from each to the next.
class Maneuvers {
 public:
  void add(const char* kind, ordered_json data) {
    const std::string id = kind + std::to_string(list_.size() + 1);
    if (!list_.empty())
      transitions_.push_back({{"abbrev", "PlanTransition"},
                              {"source_man", list_.back()["maneuver_id"]},
                              {"dest_man", id},
                              {"conditions", "ManeuverIsDone"},
                              {"actions", ordered_json::array()}});
    list_.push_back({{"abbrev", "PlanManeuver"},
                     {"maneuver_id", id},
                     {"data", std::move(data)},
                     {"start_actions", ordered_json::array()},
                     {"end_actions", ordered_json::array()}});
  }
  [[nodiscard]] const ordered_json& list() const { return list_; }
  [[nodiscard]] const ordered_json& transitions() const { return transitions_; }
  [[nodiscard]] ordered_json first() const {
    return list_.empty() ? ordered_json("") : list_.front()["maneuver_id"];
  }

 private:
  ordered_json list_ = ordered_json::array();
  ordered_json transitions_ = ordered_json::array();
};

}  // namespace

std::string plan_imc(const planning::Plan& plan, const vehicle::GliderProfile& vehicle,
                     const std::vector<std::optional<mission::Shoal>>& shoals, core::Metres hold_radius,
                     const std::string& plan_id, const std::string& name, core::UtcTime generated) {
  Maneuvers maneuvers;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& from = plan.waypoints[i - 1];
    const planning::Waypoint& to = plan.waypoints[i];
    const double speed_m_s = to.speed_through_water.value_or(vehicle.speed_through_water).value;
    const double depth_m = depth_of(plan, i, vehicle, shoals);
    if (mission::is_held_at(plan, i - 1)) {
      const double parts = std::ceil(from.wait.count() / longest_hold_s);
      for (double part = 0.0; part < parts; part += 1.0)
        maneuvers.add("Hold",
                      keep_station(from.place, from.wait.count() / parts, depth_m, speed_m_s, hold_radius));
    }
    for (const Part& part : parts_of(from, to)) maneuvers.add("Goto", go_to(part, depth_m, speed_m_s));
  }
  const ordered_json message{
      {"abbrev", "PlanSpecification"},
      {"timestamp", core::unix_seconds(generated)},
      {"src", nobody},
      {"src_ent", any_entity},
      {"dst", nobody},
      {"dst_ent", any_entity},
      {"plan_id", mission::comment_text(plan_id, 60)},
      {"description", mission::comment_text(name.empty() ? plan_id : name + ", " + plan_id, 200) +
                          "; not tried on a vehicle, check before use"},
      {"vnamespace", ""},
      {"variables", ordered_json::array()},
      {"start_man_id", maneuvers.first()},
      {"maneuvers", maneuvers.list()},
      {"transitions", maneuvers.transitions()},
      {"start_actions", ordered_json::array()},
      {"end_actions", ordered_json::array()}};
  return message.dump(1) + "\n";
}

}  // namespace floeplan::codec
