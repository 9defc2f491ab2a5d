#pragma once

#include <optional>
#include <string_view>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Reads `name(unit) value`, the text after `b_arg:` or `sensor:`. A blank before the unit, a missing unit
/// and words after the value only give warnings.
/// Returns  empty, with an error among the messages, if name or value cannot be read
[[nodiscard]] std::optional<Argument> read_setting(std::string_view text, int line, Messages& messages);

/// Reads a row of a list: longitude, then latitude, both in packed degrees and minutes.
/// Returns  empty, with an error among the messages, for a row without two numbers; a row with an invalid
///          place is returned with its error
[[nodiscard]] std::optional<WaypointRow> read_waypoint_row(std::string_view text, int line,
                                                           Messages& messages);

/// The place with two packed coordinates. Minutes of 60 and more give a warning, invalid places an error.
[[nodiscard]] geo::LonLat read_packed_place(double lon_packed, double lat_packed, int line,
                                            Messages& messages);

}  // namespace floeplan::mission
