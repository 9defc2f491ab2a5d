#pragma once

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Judges a goto_list that has its rows in the same file.
void check_list(const Behavior& list, const std::vector<WaypointRow>& rows, Messages& messages);

/// Warns of coordinates that all have as few digits before the point as decimal degrees: "-118.5687 33.4120" is
/// syntactically fine and lies off Africa.
void check_decimal_look(const std::vector<WaypointRow>& rows, Messages& messages);

/// Judges a goto_list of a mission, which has its rows inline or in another file.
void check_inline_list(const Behavior& list, Messages& messages);

/// The places that a goto_list or goto_wpt of a mission gives inline by longitude and latitude; what is given in
/// local metres or UTM is left out, with a note.
[[nodiscard]] std::vector<WaypointRow> inline_waypoints(const Behavior& behavior, Messages& messages);

}  // namespace floeplan::mission
