#pragma once

#include <vector>

#include "engine/geo/globe_window.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// What is left of the rings of an outline in the window: a place in the window is inside by the even-odd rule of the
/// results together exactly if it was inside of the ring.
/// Returns  rings whose longitudes run on without a jump, counted from the window's middle; some of their edges lead
///          along the window's rim, and may be long
/// Precondition  the ring leads round no pole, see turn_of
/// Source   Sutherland and Hodgman 1974, doi:10.1145/360767.360802, for one side of the window after the other
[[nodiscard]] std::vector<Ring> clipped(const Ring& ring, const GlobeWindow& window);

}  // namespace floeplan::geo
