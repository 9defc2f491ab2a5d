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

/// Reads a route from a file of another program or of a vehicle. From a goto list, only the rows that the
/// vehicle flies are used (mission::flown_waypoints); warnings tell what is ignored, repeated or cut off. The
/// content decides the format; `name` decides between the two kinds of mission file if both are possible, and
/// appears in messages.
/// Formats  GliderDOS lists and missions (.ma, .mi), GPX, KML, GeoJSON, CSV with columns for longitude and
///          latitude, Seaglider targets, IMC plans of Neptus (JSON), NMEA 0183 waypoints and routes; UTF-8 or UTF-16
/// Frame    longitudes are converted to [-180, 180)
/// `wanted` name or number of the route to use, if the file has several
/// `from`   position of the vehicle, if known; a goto list may begin with the row closest to it
/// Errors   all faults, with their lines if the format has lines; several routes (listed); files of
///          more than 8 MiB or 10000 places
[[nodiscard]] tl::expected<RouteFile, core::Violations> read_route_file(
    const std::string& name, std::string_view bytes, const std::optional<std::string>& wanted = {},
    std::optional<geo::LonLat> from = std::nullopt);

}  // namespace floeplan::codec
