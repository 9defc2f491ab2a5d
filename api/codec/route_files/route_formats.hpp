#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/route_files/route_choice.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::codec {

class InputReader;

/// The routes in a file of one format, or its faults.
using ReadRoutes = tl::expected<FileRoutes, core::Violations>;

/// GPX: its routes; if there are none, its tracks; if there are none, all waypoints as one route. If there
/// are routes, tracks are only used if named.
[[nodiscard]] ReadRoutes read_gpx(std::string_view bytes);
/// KML: one route for each placemark with a LineString or a gx:Track; if there are none, all Points as one
/// route. Hidden placemarks, or those in hidden folders, are only used if named.
[[nodiscard]] ReadRoutes read_kml(std::string_view bytes);
/// GeoJSON, or a bare array of positions.
[[nodiscard]] ReadRoutes read_geojson(std::string_view bytes);
/// An IMC message PlanSpecification in JSON (alone or in a PlanDB or PlanControl), or an array of them: the
/// positions of its maneuvers, beginning with the first, in the order of the transitions.
[[nodiscard]] ReadRoutes read_imc(std::string_view bytes);
/// Whether JSON looks like an IMC message.
[[nodiscard]] bool is_imc_plan(std::string_view bytes);
/// CSV with a header that names columns of longitude and latitude; separated by commas, semicolons or tabs. A
/// column such as "route" or "track" divides the rows into routes.
[[nodiscard]] ReadRoutes read_csv(std::string_view bytes);

/// NMEA 0183: the waypoints of WPL sentences in the order of the RTE sentences; without RTE sentences in the
/// order of the file. A repeated route is used once. Other sentences are ignored.
/// Errors   a wrong check sum; a route without one of its waypoints, their positions or its sentences
[[nodiscard]] ReadRoutes read_nmea(std::string_view bytes);

/// The routes of a GeoJSON value at `pointer`: one route for each feature with lines; if there are none, all
/// points as one route. Lines cut at the antimeridian are joined again. Legs and waypoints of a plan, which
/// the server returns as separate features, become the plan's route.
/// Errors   are added to the reader
[[nodiscard]] FileRoutes geojson_routes(InputReader& reader, const nlohmann::json& value,
                                        const std::string& pointer);

/// The place of a fault: "line 12".
[[nodiscard]] std::string at_line(int line);
template <messages::Code code, class... Given>
[[nodiscard]] tl::unexpected<core::Violations> route_fault(const std::string& where, const Given&... values) {
  return tl::unexpected(core::Violations{messages::fault<code>(where, values...)});
}

/// A position; if it is invalid, nullopt and a violation that names the line (at most as many as `core::note`
/// collects).
[[nodiscard]] std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat,
                                                  int line, core::Violations& faults);

}  // namespace floeplan::codec
