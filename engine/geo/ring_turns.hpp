#pragma once

#include <string>

#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// Total turn of a ring around the Earth, in degrees: 0, or for a ring around a pole 360 (eastwards) or -360
/// (westwards).
[[nodiscard]] double turn_of(const Ring& ring);

/// Why an outline in longitude and latitude is ambiguous: it leads around a pole, or it has edges so long
/// that they could go round the Earth either way. Empty if it is not ambiguous.
[[nodiscard]] std::string doubt_in_turns(const Polygon& polygon);

/// The ring with longitudes that continue without a jump. The first is within half a turn of `from_deg`.
[[nodiscard]] Ring counted_on(const Ring& ring, double from_deg);

}  // namespace floeplan::geo
