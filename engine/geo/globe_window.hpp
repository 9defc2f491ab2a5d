#pragma once

#include <limits>

namespace floeplan::geo {

/// A part of the Earth between two parallels and two meridians, or all the way round.
struct GlobeWindow {
  double middle_lon_deg{};
  double half_width_deg{std::numeric_limits<double>::infinity()};  // below 180; infinite: all longitudes
  double south_deg{-90.0};
  double north_deg{90.0};
};

}  // namespace floeplan::geo
