#include <algorithm>

#include "api/codec/route_formats.hpp"
#include "api/codec/xml_scan.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/mission/line_words.hpp"

namespace floeplan::codec {
namespace {

std::optional<double> number_at(const XmlElement& element, const char* attribute) {
  const auto found = element.attributes.find(attribute);
  if (found == element.attributes.end()) return std::nullopt;
  return mission::parse_number(found->second);
}

/// "lon,lat,height lon,lat ...".
void read_coordinates(const XmlElement& element, std::vector<geo::LonLat>& places, core::Violations& faults) {
  std::string text = element.text;
  std::ranges::replace(text, '\n', ' ');
  std::ranges::replace(text, '\r', ' ');
  for (const std::string_view word : mission::words_of(text)) {
    const std::size_t comma = word.find(',');
    const std::string_view rest = comma == std::string_view::npos ? "" : word.substr(comma + 1);
    const auto place = place_of(mission::parse_number(word.substr(0, comma)),
                                mission::parse_number(rest.substr(0, rest.find(','))), element.line, faults);
    if (!place) return;
    places.push_back(*place);
  }
}

}  // namespace

RoutePlaces read_gpx(std::string_view bytes) {
  const auto elements = scan_xml(bytes);
  for (const char* wanted : {"rtept", "trkpt", "wpt"}) {
    std::vector<geo::LonLat> places;
    core::Violations faults;
    for (const XmlElement& element : elements) {
      if (core::is_full(faults)) break;
      if (element.name != wanted) continue;
      if (const auto place =
              place_of(number_at(element, "lon"), number_at(element, "lat"), element.line, faults))
        places.push_back(*place);
    }
    if (!faults.empty()) return tl::unexpected(std::move(faults));
    if (!places.empty()) return places;
  }
  return route_fault("file", "holds no rtept, trkpt or wpt");
}

RoutePlaces read_kml(std::string_view bytes) {
  std::vector<geo::LonLat> line;
  std::vector<geo::LonLat> points;
  core::Violations faults;
  std::string geometry;
  for (const XmlElement& element : scan_xml(bytes)) {
    if (core::is_full(faults)) break;
    if (element.name == "LineString" || element.name == "Point" || element.name == "Polygon")
      geometry = element.name;
    if (element.name != "coordinates") continue;
    if (geometry == "LineString" && line.empty()) read_coordinates(element, line, faults);
    if (geometry == "Point") read_coordinates(element, points, faults);
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (line.empty() && points.empty()) return route_fault("file", "holds no LineString and no Point");
  return line.empty() ? points : line;
}

}  // namespace floeplan::codec
