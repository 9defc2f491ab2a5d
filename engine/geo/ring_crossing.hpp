#pragma once

#include <optional>

#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// Whether the outline of a ring crosses itself, as it does if its corners are in a wrong order. The even-odd
/// rule then hardly gives the intended area.
struct RingCrossing {
  std::optional<LonLat> place;   // of one crossing, that of the westernmost edges; longitude in [-180, 180)
  bool is_looked_through{true};  // false: too many edges share longitudes, so not all were compared
};

/// Edges that touch, or pass within a centimetre, do not count as crossing: outlines are cut open in this
/// way, and share corners.
/// Time     proportional to the number of pairs of edges that share a longitude, at most some 50 million
[[nodiscard]] RingCrossing find_crossing(const Ring& ring);

}  // namespace floeplan::geo
