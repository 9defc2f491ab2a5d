#pragma once

#include <optional>
#include <string_view>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Reads `name(unit) value`, what follows `b_arg:` or `sensor:`. Leniently: a blank before the unit, a missing
/// unit and words after the value are warned of.
/// Returns  nothing, and an error among the messages, where name or value cannot be made out
[[nodiscard]] std::optional<Argument> read_setting(std::string_view text, int line, Messages& messages);

/// Reads a row of a list, longitude before latitude, each in packed degrees and minutes.
/// Returns  nothing, and an error among the messages, for a row without two numbers; a row that is no place on
///          the Earth is returned all the same, with its error
[[nodiscard]] std::optional<WaypointRow> read_waypoint_row(std::string_view text, int line,
                                                           Messages& messages);

/// The place of two packed angles. Minutes of 60 and more are warned of, places off the Earth are errors.
[[nodiscard]] geo::LonLat read_packed_place(double lon_packed, double lat_packed, int line,
                                            Messages& messages);

}  // namespace floeplan::mission
