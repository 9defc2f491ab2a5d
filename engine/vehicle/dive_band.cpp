#include "engine/vehicle/dive_band.hpp"

#include <algorithm>

namespace floeplan::vehicle {

DiveBand flown_band(const DiveLimits& limits, std::optional<core::Metres> sea_bed) {
  core::Metres bottom = limits.dive_to;
  if (sea_bed) bottom = std::min(bottom, *sea_bed - limits.altimeter_margin);
  return {.top = limits.climb_to, .bottom = std::max(bottom, limits.climb_to + lowest_tooth)};
}

}  // namespace floeplan::vehicle
