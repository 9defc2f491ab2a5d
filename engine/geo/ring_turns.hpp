#pragma once

#include <string>

#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// How far round the Earth a ring leads, degrees: 0, or a turn east (positive) or west round a pole.
[[nodiscard]] double turn_of(const Ring& ring);

/// Why an outline in longitude and latitude is not clear: it leads round a pole, or it has edges so long that they
/// could lead round the Earth either way; empty when it is clear.
[[nodiscard]] std::string doubt_in_turns(const Polygon& polygon);

/// The longitudes of a ring, counted on from the first, which is within half a turn of `from_deg`, without a jump.
[[nodiscard]] Ring counted_on(const Ring& ring, double from_deg);

}  // namespace floeplan::geo
