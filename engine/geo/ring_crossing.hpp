#pragma once

#include <optional>

#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// Whether the outline of a ring crosses itself, as it does where corners are listed out of order: its inside by the
/// even-odd rule is then hardly what was meant.
struct RingCrossing {
  std::optional<LonLat> place;   // of one crossing, the westernmost edges first; longitude in [-180, 180)
  bool is_looked_through{true};  // false: so many edges lie beside each other that not all were compared
};

/// Edges that touch, or pass each other by less than a centimetre, do not cross: outlines are cut open so, and share
/// corners.
/// Time     as the number of pairs of edges that share a longitude, at most some 50 million
[[nodiscard]] RingCrossing find_crossing(const Ring& ring);

}  // namespace floeplan::geo
