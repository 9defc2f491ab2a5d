#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/route_files/route_choice.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// Reads a route from a file of another program or of a vehicle: of a goto list the rows that the vehicle flies
/// (mission::flown_waypoints), and what that leaves out, repeats or cuts short is warned of. What it is its content says; `name` helps where
/// both kinds of mission file are possible, and is named in messages.
/// Formats  GliderDOS lists and missions (.ma, .mi), GPX, KML, GeoJSON, CSV with columns for longitude and
///          latitude, Seaglider targets, IMC plans of Neptus (JSON), NMEA 0183 waypoints and routes; UTF-8 or UTF-16
/// Frame    longitudes are brought into [-180, 180), however the file counts them
/// `wanted` the name or number of the route to take, of a file with several
/// `from`   where the vehicle is, if that is known; a goto list may begin with the row closest to it
/// Errors   what is wrong, each with its line where the format has lines; several routes, with their names; files of
///          more than 8 MiB or 10000 places
[[nodiscard]] tl::expected<RouteFile, core::Violations> read_route_file(
    const std::string& name, std::string_view bytes, const std::optional<std::string>& wanted = {},
    std::optional<geo::LonLat> from = std::nullopt);

}  // namespace floeplan::codec
