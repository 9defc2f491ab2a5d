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

/// The routes that a file of one format holds, or what is wrong with it.
using ReadRoutes = tl::expected<FileRoutes, core::Violations>;

/// GPX: its routes; where there are none its tracks, and else the single waypoints as one route. Tracks beside routes
/// count where they are named.
[[nodiscard]] ReadRoutes read_gpx(std::string_view bytes);
/// KML: a route for each placemark with a LineString or a gx:Track; where there is none the Points as one route. What
/// is hidden, or lies in a hidden folder, counts where it is named.
[[nodiscard]] ReadRoutes read_kml(std::string_view bytes);
/// GeoJSON, or a bare array of positions.
[[nodiscard]] ReadRoutes read_geojson(std::string_view bytes);
/// An IMC message PlanSpecification in JSON (alone or in a PlanDB or PlanControl), or an array of them: the places of its
/// maneuvers from the first on, in the order of the transitions.
[[nodiscard]] ReadRoutes read_imc(std::string_view bytes);
/// Whether JSON looks like an IMC message.
[[nodiscard]] bool is_imc_plan(std::string_view bytes);
/// CSV with a header that names columns for longitude and latitude, between commas, semicolons or tabs; a column like
/// "route" or "track" divides it into routes.
[[nodiscard]] ReadRoutes read_csv(std::string_view bytes);

/// NMEA 0183: the waypoints of the sentences WPL in the order of the RTE sentences, or in their own where there are
/// none. A route that is sent again counts once. Other sentences are passed over.
/// Errors   a check sum that does not fit; a waypoint of a route, its place or one of its sentences that is not there
[[nodiscard]] ReadRoutes read_nmea(std::string_view bytes);

/// The routes of a GeoJSON value at `pointer`: a route for each feature with lines; where there is none the points as
/// one route. Lines that are cut at the antimeridian are whole again; legs and waypoints of a plan that the server gave
/// as features of their own are the plan's route.
/// Errors   noted
[[nodiscard]] FileRoutes geojson_routes(InputReader& reader, const nlohmann::json& value,
                                        const std::string& pointer);

/// "line 12", as a violation names it.
[[nodiscard]] std::string at_line(int line);
template <messages::Code code, class... Given>
[[nodiscard]] tl::unexpected<core::Violations> route_fault(const std::string& where, const Given&... values) {
  return tl::unexpected(core::Violations{messages::fault<code>(where, values...)});
}

/// A place, or a fault that names the line, as far as `core::note` goes.
[[nodiscard]] std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat,
                                                  int line, core::Violations& faults);

}  // namespace floeplan::codec
