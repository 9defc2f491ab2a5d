#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// The places that a file of one format holds, in their order, or what is wrong with it.
using RoutePlaces = tl::expected<std::vector<geo::LonLat>, core::Violations>;

/// GPX: the points of a route; where there is none those of a track, and else single waypoints.
[[nodiscard]] RoutePlaces read_gpx(std::string_view bytes);
/// KML: the first LineString; where there is none the Points.
[[nodiscard]] RoutePlaces read_kml(std::string_view bytes);
/// GeoJSON: the first LineString; where there is none the Points.
[[nodiscard]] RoutePlaces read_geojson(std::string_view bytes);
/// An IMC message PlanSpecification in JSON (alone or in a PlanDB or PlanControl): the places of its maneuvers from the
/// first on, in the order of the transitions.
[[nodiscard]] RoutePlaces read_imc(std::string_view bytes);
/// Whether JSON looks like an IMC message.
[[nodiscard]] bool is_imc_plan(std::string_view bytes);
/// CSV with a header that names columns for longitude and latitude, between commas, semicolons or tabs.
[[nodiscard]] RoutePlaces read_csv(std::string_view bytes);

/// NMEA 0183: the waypoints of the sentences WPL in the order of the RTE sentences, or in their own where there are
/// none.
/// Other sentences are passed over.
/// Errors   a check sum that does not fit, several routes, a waypoint of the route or its place that is not there
[[nodiscard]] RoutePlaces read_nmea(std::string_view bytes);

/// Of a route file; a plan uses far fewer.
inline constexpr std::size_t max_places = 10'000;

/// "line 12", as a violation names it.
[[nodiscard]] std::string at_line(int line);
[[nodiscard]] tl::unexpected<core::Violations> route_fault(const std::string& where, const std::string& rule);

/// A place, or a fault that names the line, as far as `core::note` goes.
[[nodiscard]] std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat,
                                                  int line, core::Violations& faults);

}  // namespace floeplan::codec
