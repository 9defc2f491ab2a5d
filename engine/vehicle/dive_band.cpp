#include "engine/vehicle/dive_band.hpp"

#include <algorithm>

namespace floeplan::vehicle {

DiveBand flown_band(const DiveLimits& limits, std::optional<core::Metres> sea_bed) {
  core::Metres bottom = limits.dive_to;
  if (sea_bed) bottom = std::min(bottom, *sea_bed - limits.altimeter_margin);
  return {.top = limits.climb_to, .bottom = std::max(bottom, limits.climb_to + lowest_tooth)};
}

DiveBand band_below(core::Metres upper_turn, const DiveBand& band) {
  if (upper_turn <= band.top) return band;
  return {std::min(upper_turn, band.bottom - lowest_tooth), band.bottom};
}

}  // namespace floeplan::vehicle
