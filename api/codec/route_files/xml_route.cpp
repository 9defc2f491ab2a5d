#include <algorithm>

#include "api/codec/reading/input_reader.hpp"
#include "api/codec/route_files/route_formats.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/mission/document/line_words.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::codec {
namespace {

using xml::Element;
using Line = std::vector<geo::LonLat>;

/// The points with this element name, directly below an element.
Line points_of(const Element& element, std::string_view point, core::Violations& faults) {
  Line line;
  for (const Element& child : element.children) {
    if (child.name != point || core::is_full(faults)) continue;
    const std::string lon = child.attribute("lon");
    const std::string lat = child.attribute("lat");
    const auto place = place_of(mission::parse_number(xml::trimmed(lon)),
                                mission::parse_number(xml::trimmed(lat)), child.line, faults);
    if (place) line.push_back(*place);
  }
  return line;
}

void add(std::vector<NamedRoute>& routes, NamedRoute route) {
  std::erase_if(route.parts, [](const Line& part) { return part.empty(); });
  if (!route.parts.empty()) routes.push_back(std::move(route));
}

/// Whether a route or track is hidden; OpenCPN writes this as "opencpn:viz" in its extensions.
bool is_hidden_in_gpx(const Element& element) {
  const Element* const extensions = element.child("extensions");
  if (extensions == nullptr) return false;
  const std::string shown = extensions->text_of("viz");
  return shown == "0" || shown == "false";
}

/// Reads the geometries of KML.
class KmlReader {
 public:
  ReadRoutes read(const Element& document) {
    gather(document, false);
    if (!faults_.empty()) return tl::unexpected(std::move(faults_));
    if (lines_.empty() && points_.empty() && hidden_points_.empty())
      return route_fault<"holds-no">("file", "LineString and no Point");
    if (lines_.empty() && points_.empty())
      add(lines_, {"", {std::move(hidden_points_)}, Gaps::refused, "hidden"});
    if (lines_.empty()) add(lines_, {"", {std::move(points_)}});
    FileRoutes file{std::move(lines_), {}};
    if (heights_ > 0) file.warnings.push_back(heights_left_out(heights_));
    return file;
  }

 private:
  /// Collects the geometries below a folder or in a placemark. A geometry outside of placemarks is a route of
  /// its own.
  void gather(const Element& element, bool is_hidden) {
    is_hidden = is_hidden || element.text_of("visibility") == "0";
    NamedRoute route{element.text_of("name"), {}, Gaps::refused, is_hidden ? "hidden" : ""};
    for (const Element& child : element.children) {
      if (core::is_full(faults_)) return;
      if (!read_geometry(child, route)) gather(child, is_hidden);
      if (element.name != "Placemark" && !route.parts.empty()) {
        add(lines_, {"", std::move(route.parts), route.gaps, route.aside});
        route.parts.clear();
      }
    }
    add(lines_, std::move(route));
  }

  /// Adds a geometry's lines to the route, or its points to the list of points. False if the element is no
  /// geometry.
  bool read_geometry(const Element& element, NamedRoute& route) {
    if (element.name == "LineString") {
      route.parts.push_back(coordinates_of(element));
    } else if (element.name == "Track") {
      route.parts.push_back(track(element));
      route.gaps = Gaps::flown;
    } else if (element.name == "Point") {
      Line& points = route.aside.empty() ? points_ : hidden_points_;
      const Line place = coordinates_of(element);
      points.insert(points.end(), place.begin(), place.end());
    } else if (element.name == "MultiGeometry" || element.name == "MultiTrack") {
      for (const Element& part : element.children) read_geometry(part, route);
    } else {
      return element.name == "Polygon" || element.name == "LinearRing" || element.name == "Model";
    }
    return true;
  }

  /// The positions in an element's coordinates, "lon,lat,height lon,lat ...".
  Line coordinates_of(const Element& element) {
    Line line;
    const Element* const coordinates = element.child("coordinates");
    if (coordinates == nullptr) return line;
    for (std::string_view rest = xml::trimmed(coordinates->text); !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
      rest = xml::trimmed(rest.substr(word.size()));
      if (!add_place(word, ',', coordinates->line, line)) break;
    }
    return line;
  }

  /// The positions in the elements gx:coord, "lon lat height".
  Line track(const Element& element) {
    Line line;
    for (const Element& child : element.children)
      if (child.name == "coord" && !add_place(xml::trimmed(child.text), ' ', child.line, line)) break;
    return line;
  }

  bool add_place(std::string_view text, char separator, int line_number, Line& line) {
    std::vector<std::optional<double>> numbers;
    while (true) {
      const std::size_t end = text.find(separator);
      numbers.push_back(mission::parse_number(text.substr(0, end)));
      if (end == std::string_view::npos) break;
      text.remove_prefix(end + 1);
    }
    numbers.resize(std::max<std::size_t>(numbers.size(), 3));
    if (numbers[2].value_or(0.0) != 0.0) ++heights_;
    const auto place = place_of(numbers[0], numbers[1], line_number, faults_);
    if (place) line.push_back(*place);
    return place.has_value();
  }

  std::vector<NamedRoute> lines_;
  Line points_;
  Line hidden_points_;
  std::size_t heights_{};
  core::Violations faults_;
};

}  // namespace

ReadRoutes read_gpx(std::string_view bytes) {
  const auto document = xml::parse(bytes);
  if (!document) return route_fault<"route-file-unreadable">("file", document.error());
  std::vector<NamedRoute> routes;
  std::vector<NamedRoute> tracks;
  core::Violations faults;
  add(routes, {"", {points_of(*document, "rtept", faults)}});
  for (const Element& element : document->children) {
    const std::string aside = is_hidden_in_gpx(element) ? "hidden" : "";
    if (element.name == "rte")
      add(routes, {element.text_of("name"), {points_of(element, "rtept", faults)}, Gaps::refused, aside});
    if (element.name != "trk") continue;
    NamedRoute track{element.text_of("name"), {points_of(element, "trkpt", faults)}, Gaps::flown, aside};
    for (const Element& segment : element.children)
      if (segment.name == "trkseg") track.parts.push_back(points_of(segment, "trkpt", faults));
    add(tracks, std::move(track));
  }
  const bool has_routes =
      std::ranges::any_of(routes, [](const NamedRoute& route) { return route.aside.empty(); });
  for (NamedRoute& track : tracks) {
    if (has_routes && track.aside.empty()) track.aside = "a track beside a route";
    routes.push_back(std::move(track));
  }
  if (routes.empty()) add(routes, {"", {points_of(*document, "wpt", faults)}});
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (routes.empty()) return route_fault<"holds-no">("file", "rtept, trkpt or wpt");
  return FileRoutes{std::move(routes), {}};
}

ReadRoutes read_kml(std::string_view bytes) {
  const auto document = xml::parse(bytes);
  if (!document) return route_fault<"route-file-unreadable">("file", document.error());
  return KmlReader{}.read(*document);
}

}  // namespace floeplan::codec
