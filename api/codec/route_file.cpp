#include "api/codec/route_file.hpp"

#include "api/codec/route_formats.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/mission/read_document.hpp"

namespace floeplan::codec {
namespace {

constexpr std::size_t max_bytes = 1 << 20;

/// A list or mission of a Slocum, or the targets of a Seaglider. Decimal degrees are refused: nobody should fly what
/// they would be taken for.
tl::expected<RouteFile, core::Violations> read_mission(const std::string& name, std::string_view bytes) {
  const mission::Document document = mission::read_document(name, bytes);
  RouteFile route;
  core::Violations faults;
  for (const auto& message : document.messages) {
    const bool refused = message.severity == mission::Severity::error || message.code == "decimal_degrees";
    if (refused) core::note(faults, {at_line(message.line), message.text});
    if (!refused && message.severity == mission::Severity::warning)
      route.warnings.push_back(name + ", " + at_line(message.line) + ": " + message.text);
  }
  for (const auto& row : document.waypoints) route.places.push_back(row.place);
  if (faults.empty() && route.places.empty())
    faults.push_back(
        {"file", "holds no waypoints by longitude and latitude; a mission names its list in another file"});
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return route;
}

/// Seaglider targets have lines of fields like lat=4807.5.
bool looks_like_targets(std::string_view bytes) {
  return bytes.find("lat=") != std::string_view::npos && bytes.find("lon=") != std::string_view::npos &&
         bytes.find('<') == std::string_view::npos;
}

bool looks_like_mission(const std::string& name, std::string_view bytes) {
  const std::string lower = core::lower_case(name);
  return lower.ends_with(".ma") || lower.ends_with(".mi") ||
         core::lower_case(bytes.substr(0, 4096)).find("behavior") != std::string::npos;
}

tl::expected<RouteFile, core::Violations> checked(RoutePlaces places) {
  if (!places) return tl::unexpected(places.error());
  if (places->size() > max_places) return route_fault("file", "holds more than 10000 places");
  return RouteFile{std::move(*places), {}};
}

tl::expected<RouteFile, core::Violations> read_by_content(const std::string& name, std::string_view bytes) {
  if (bytes.size() > max_bytes) return route_fault("file", "is larger than 1 MiB");
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return route_fault("file", "is empty");

  if (bytes[first] == '{') return checked(is_imc_plan(bytes) ? read_imc(bytes) : read_geojson(bytes));
  const std::string_view head = bytes.substr(first, 4096);
  if (head.front() == '<' && head.find("<gpx") != std::string_view::npos) return checked(read_gpx(bytes));
  if (head.front() == '<' && head.find("<kml") != std::string_view::npos) return checked(read_kml(bytes));
  if (head.front() == '$') return checked(read_nmea(bytes));
  if (looks_like_mission(name, bytes)) return read_mission(name, bytes);
  if (looks_like_targets(bytes)) return read_mission("targets", bytes);
  return checked(read_csv(bytes));
}

}  // namespace

tl::expected<RouteFile, core::Violations> read_route_file(const std::string& name, std::string_view bytes) {
  auto route = read_by_content(name, bytes);
  if (route) {
    for (geo::LonLat& place : route->places) place.lon_deg = geo::wrap_longitude(place.lon_deg);
  }
  return route;
}

}  // namespace floeplan::codec
