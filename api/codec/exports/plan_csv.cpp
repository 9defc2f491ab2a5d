#include <array>
#include <cstdio>
#include <optional>

#include "api/codec/bytes/bare_value.hpp"
#include "api/codec/exports/plan_files.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

std::string cell(std::optional<double> value, int decimals) {
  if (!value) return "";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, *value);
  return text.data();
}

}  // namespace

std::string plan_csv(const planning::Plan& plan) {
  std::string text = "index,lon_deg,lat_deg,eta_utc,leg_m,course_deg,speed_over_ground_m_s,depth_m,wait_s\n";
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& waypoint = plan.waypoints[i];
    text += std::to_string(i) + "," + cell(waypoint.place.lon_deg, 7) + "," +
            cell(waypoint.place.lat_deg, 7) + "," + core::iso8601(waypoint.eta) + "," +
            cell(bare(waypoint.leg_length), 1) + "," + cell(waypoint.course_deg, 2) + "," +
            cell(bare(waypoint.speed_over_ground), 4) + "," + cell(bare(waypoint.depth), 1) + "," +
            cell(waypoint.wait.count(), 0) + "\n";
  }
  return text;
}

}  // namespace floeplan::codec
