#include "engine/planning/ice/nearest_ice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floeplan::planning::ice {

core::Metres deepest_turn_within(core::Metres distance, const UnderIce& ice, geo::PlanePoint place,
                                 core::Seconds when) {
  // Judgements: ice data have cells of kilometres, and position errors grow to some tens of kilometres.
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

std::optional<core::Metres> nearest_ice_within(core::Metres distance, const UnderIce& ice,
                                               geo::PlanePoint place, core::Seconds when) {
  // Judgements: near the place, where every metre counts, the rings are close to each other. Farther out the
  // rings, and the samples on each, are no farther apart than the cells of ice data, some kilometres.
  constexpr double first_ring_m = 50.0;
  constexpr double most_apart_m = 1000.0;
  constexpr int least_looks_of_a_ring = 24;
  constexpr int halvings = 6;
  const auto is_ice = [&](double radius_m, double angle) {
    const geo::PlanePoint there{place.x_m + radius_m * std::cos(angle),
                                place.y_m + radius_m * std::sin(angle)};
    return ice.least_upper_turn(there, when).value > 0.0;
  };
  if (is_ice(0.0, 0.0)) return core::Metres{0.0};
  for (double inner_m = ice.least_way_to_dense_ice(place).value; inner_m < distance.value;) {
    const double apart_m = std::clamp(inner_m, first_ring_m, most_apart_m);
    const double outer_m = std::min(inner_m + apart_m, distance.value);
    double nearest_m = std::numeric_limits<double>::infinity();
    const int looks_of_a_ring = std::max(
        least_looks_of_a_ring, static_cast<int>(std::ceil(2.0 * std::numbers::pi * outer_m / most_apart_m)));
    for (int look = 0; look < looks_of_a_ring; ++look) {
      const double angle = 2.0 * std::numbers::pi * look / looks_of_a_ring;
      if (!is_ice(outer_m, angle)) continue;
      double open_m = inner_m;
      double ice_m = outer_m;
      for (int i = 0; i < halvings; ++i) {
        const double middle_m = 0.5 * (open_m + ice_m);
        (is_ice(middle_m, angle) ? ice_m : open_m) = middle_m;
      }
      nearest_m = std::min(nearest_m, open_m);
    }
    if (std::isfinite(nearest_m)) return core::Metres{nearest_m};
    inner_m = outer_m;
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::ice
