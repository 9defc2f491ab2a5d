#include "engine/planning/ice_beside.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/planning/under_ice.hpp"

namespace floeplan::planning {

core::Metres deepest_turn_within(core::Metres distance, const UnderIce& ice, geo::PlanePoint place,
                                 core::Seconds when) {
  // Judgements: ice is told in cells of kilometres, and errors grow to some tens of them.
  constexpr int rings = 4;
  constexpr int looks_of_a_ring = 8;
  core::Metres deepest = ice.least_upper_turn(place, when);
  if (distance.value <= 0.0) return deepest;
  for (int ring = 1; ring <= rings; ++ring) {
    const double radius_m = distance.value * ring / rings;
    for (int look = 0; look < looks_of_a_ring; ++look) {
      const double angle = 2.0 * std::numbers::pi * look / looks_of_a_ring;
      const geo::PlanePoint there{place.x_m + radius_m * std::cos(angle),
                                  place.y_m + radius_m * std::sin(angle)};
      deepest = std::max(deepest, ice.least_upper_turn(there, when));
    }
  }
  return deepest;
}

}  // namespace floeplan::planning
