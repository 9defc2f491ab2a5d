#pragma once

#include <vector>

#include "engine/geo/globe_window.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// The parts of a ring inside the window. By the even-odd rule over all results, a place in the window is
/// inside exactly if it was inside the ring.
/// Returns  rings whose longitudes continue without a jump, counted from the window's middle; some edges lie
///          along the window's rim and may be long
/// Precondition  the ring does not lead around a pole, see turn_of
/// Source   Sutherland and Hodgman 1974, doi:10.1145/360767.360802, for one side of the window after another
[[nodiscard]] std::vector<Ring> clipped(const Ring& ring, const GlobeWindow& window);

}  // namespace floeplan::geo
