#include "api/codec/route_files/route_file.hpp"

#include "api/codec/route_files/route_formats.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/utf8_text.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::codec {
namespace {

constexpr std::size_t max_bytes = 8 << 20;

/// Reads a list or mission of a Slocum, or the targets of a Seaglider. Decimal degrees are refused, because
/// the vehicle would read them as degrees and minutes.
ReadRoutes read_mission(const std::string& name, std::string_view bytes, std::optional<geo::LonLat> from) {
  const mission::Document document = mission::read_document(name, bytes);
  std::vector<geo::LonLat> places;
  std::string left_out;
  FileRoutes file;
  core::Violations faults;
  for (const auto& message : document.messages) {
    const bool refused = message.severity == mission::Severity::error || message.code == "decimal_degrees";
    if (refused) core::note(faults, messages::fault<"mission-refused">(at_line(message.line), message.text));
    if (!refused && message.severity == mission::Severity::warning)
      file.warnings.push_back(name + ", " + at_line(message.line) + ": " + message.text);
  }
  if (faults.empty()) {
    mission::FlownWaypoints flown = mission::flown_waypoints(document, from);
    for (const auto& row : flown.rows) places.push_back(row.place);
    for (const std::string& note : flown.notes) file.warnings.push_back(name + ": " + note);
    if (!flown.notes.empty()) left_out = flown.notes.front();
    faults = std::move(flown.faults);
  }
  if (faults.empty() && places.empty())
    faults.push_back(messages::fault<"no-waypoints-by-place">(
        "file", left_out.empty() ? "if its lists are in separate files, give one of these files"
                                 : left_out + "; write them in degrees and minutes (wpt_units 2)"));
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  file.routes.push_back({"", {std::move(places)}});
  return file;
}

/// Whether a text looks like Seaglider targets, whose lines have fields such as lat=4807.5.
bool looks_like_targets(std::string_view bytes) {
  return bytes.find("lat=") != std::string_view::npos && bytes.find("lon=") != std::string_view::npos &&
         bytes.find('<') == std::string_view::npos;
}

bool looks_like_mission(const std::string& name, std::string_view bytes) {
  const std::string lower = core::lower_case(name);
  return lower.ends_with(".ma") || lower.ends_with(".mi") ||
         core::lower_case(bytes.substr(0, 4096)).find("behavior") != std::string::npos;
}

ReadRoutes read_by_content(const std::string& name, std::string_view text, std::optional<geo::LonLat> from) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return route_fault<"route-file-empty">("file");
  if (text.starts_with("PK\x03\x04")) return route_fault<"file-is-archive">("file");

  const char start = text[first];
  if (start == '{' || start == '[') return is_imc_plan(text) ? read_imc(text) : read_geojson(text);
  if (start == '$') return read_nmea(text);
  const std::string root = xml::root_name(text);
  if (root == "gpx") return read_gpx(text);
  if (root == "kml") return read_kml(text);
  if (looks_like_mission(name, text)) return read_mission(name, text, from);
  if (looks_like_targets(text)) return read_mission("targets", text, from);
  if (start == '<') return route_fault<"unknown-xml">("file", core::cut_short(root, 40));
  return read_csv(text);
}

}  // namespace

tl::expected<RouteFile, core::Violations> read_route_file(const std::string& name, std::string_view bytes,
                                                          const std::optional<std::string>& wanted,
                                                          std::optional<geo::LonLat> from) {
  if (bytes.size() > max_bytes) return route_fault<"file-too-large">("file", max_bytes >> 20);
  auto routes = read_by_content(name, core::utf8_text(bytes), from);
  if (!routes) return tl::unexpected(std::move(routes.error()));
  return choose_route(std::move(*routes), wanted);
}

}  // namespace floeplan::codec
