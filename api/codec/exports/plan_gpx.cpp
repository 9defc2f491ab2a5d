#include <array>
#include <cstdio>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/xml_text.hpp"
#include "api/codec/exports/plan_files.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

std::string route_point(const planning::Waypoint& waypoint, std::size_t index) {
  std::array<char, 80> start{};
  std::snprintf(start.data(), start.size(), "    <rtept lat=\"%.7f\" lon=\"%.7f\">", waypoint.place.lat_deg,
                geo::wrap_longitude(waypoint.place.lon_deg));
  return start.data() + ("<time>" + core::iso8601(waypoint.eta) + "</time><name>" + waypoint_label(index) +
                         "</name></rtept>\n");
}

}  // namespace

std::string plan_gpx(const planning::Plan& plan, const std::string& plan_id, const std::string& name) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<gpx version=\"1.1\" creator=\"floeplan\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
      "  <rte>\n";
  text += "    <name>" + xml_text(name.empty() ? plan_id : name) + "</name>\n";
  text += "    <desc>Plan " + xml_text(plan_id) + ", departure " + core::iso8601(plan.departure) +
          ", arrival " + core::iso8601(plan.arrival) + "</desc>\n";
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) text += route_point(plan.waypoints[i], i);
  return text + "  </rte>\n</gpx>\n";
}

}  // namespace floeplan::codec
