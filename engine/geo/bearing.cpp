#include "engine/geo/bearing.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/core/units.hpp"

namespace floeplan::geo {

Bearing Bearing::degrees(double clockwise_from_north_deg) {
  const double angle = core::degrees_to_radians(clockwise_from_north_deg);
  return {std::sin(angle), std::cos(angle)};
}

Bearing Bearing::towards(double east, double north) {
  const double length = std::hypot(east, north);
  if (length == 0.0) return {0.0, 1.0};
  return {east / length, north / length};
}

double Bearing::degrees() const {
  const double angle = core::radians_to_degrees(std::atan2(east_, north_));
  return angle < 0.0 ? std::fmod(angle + 360.0, 360.0) : angle + 0.0;  // adding 0.0 avoids minus zero
}

std::string_view compass_point(Bearing bearing) {
  static constexpr std::array<std::string_view, 8> names{"north", "north-east", "east", "south-east",
                                                         "south", "south-west", "west", "north-west"};
  return names[static_cast<std::size_t>(std::lround(bearing.degrees() / 45.0)) % names.size()];
}

}  // namespace floeplan::geo
