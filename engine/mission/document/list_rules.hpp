#pragma once

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Checks a goto_list whose rows are in the same file.
void check_list(const Behavior& list, const std::vector<WaypointRow>& rows, Messages& messages);

/// Warns if all coordinates have so few digits before the point that they look like decimal degrees:
/// "-118.5687 33.4120" is valid syntax for a place off Africa.
void check_decimal_look(const std::vector<WaypointRow>& rows, Messages& messages);

/// Checks a goto_list of a mission, whose rows are inline or in another file.
void check_inline_list(const Behavior& list, Messages& messages);

/// The places that a goto_list or goto_wpt of a mission gives inline by longitude and latitude. Places in
/// local metres or UTM are left out, with a note.
[[nodiscard]] std::vector<WaypointRow> inline_waypoints(const Behavior& behavior, Messages& messages);

}  // namespace floeplan::mission
