#include <array>
#include <cstdio>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/xml_text.hpp"
#include "api/codec/exports/plan_files.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

std::string coordinates(geo::LonLat place) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.7f,%.7f", place.lon_deg, place.lat_deg);
  return text.data();
}

std::string placemark(const planning::Waypoint& waypoint, std::size_t index) {
  return "    <Placemark><name>" + waypoint_label(index) + "</name><TimeStamp><when>" +
         core::iso8601(waypoint.eta) + "</when></TimeStamp><Point><coordinates>" +
         coordinates(waypoint.place) + "</coordinates></Point></Placemark>\n";
}

}  // namespace

std::string plan_kml(const planning::Plan& plan, const std::string& plan_id, const std::string& name) {
  const std::string title = xml_text(name.empty() ? plan_id : name);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n  <Document>\n    <name>" +
      title + "</name>\n    <description>Plan " + xml_text(plan_id) + ", departure " +
      core::iso8601(plan.departure) + ", arrival " + core::iso8601(plan.arrival) + "</description>\n";
  // Longitudes must not jump at the antimeridian, or map programs draw a line around the globe.
  text += "    <Placemark><name>" + title + "</name><LineString><tessellate>1</tessellate><coordinates>";
  double lon_deg = plan.waypoints.empty() ? 0.0 : geo::wrap_longitude(plan.waypoints.front().place.lon_deg);
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const geo::LonLat place = plan.waypoints[i].place;
    lon_deg += geo::longitude_difference(lon_deg, place.lon_deg);
    text += (i == 0 ? "" : " ") + coordinates({lon_deg, place.lat_deg});
  }
  text += "</coordinates></LineString></Placemark>\n";
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) text += placemark(plan.waypoints[i], i);
  return text + "  </Document>\n</kml>\n";
}

}  // namespace floeplan::codec
