#include "engine/tide/ellipse.hpp"

#include <cmath>

#include "engine/core/units.hpp"

namespace floeplan::tide {
namespace {

double within(double angle_deg, double turn_deg) {
  const double rest = std::fmod(angle_deg, turn_deg);
  const double positive = rest < 0.0 ? rest + turn_deg : rest;
  return positive < turn_deg ? positive : 0.0;
}

}  // namespace

// With the constants U and V of its components, the current is u + i v = w+ exp(i V) + w- exp(-i V), where w+
// = (U + i V) / 2 and w- = conj(U - i V) / 2. One vector rotates counter-clockwise, the other clockwise.
Ellipse ellipse_of(const CurrentConstants& constants) {
  constexpr std::complex<double> i{0.0, 1.0};
  const std::complex<double> counter_clockwise = 0.5 * (constants.east + i * constants.north);
  const std::complex<double> clockwise = 0.5 * std::conj(constants.east - i * constants.north);
  const double a = std::arg(counter_clockwise);
  const double b = std::arg(clockwise);

  Ellipse ellipse;
  ellipse.major = std::abs(counter_clockwise) + std::abs(clockwise);
  ellipse.minor = std::abs(counter_clockwise) - std::abs(clockwise);
  const double inclination_deg = core::radians_to_degrees(0.5 * (a + b));
  ellipse.inclination_deg = within(inclination_deg, 180.0);
  // If the other end of the axis is named, the phase changes by half a period.
  const double turned_deg = within(inclination_deg, 360.0) - ellipse.inclination_deg;
  ellipse.phase_deg = within(core::radians_to_degrees(0.5 * (b - a)) + turned_deg, 360.0);
  return ellipse;
}

CurrentConstants constants_of(const Ellipse& ellipse) {
  constexpr std::complex<double> i{0.0, 1.0};
  const double inclination = core::degrees_to_radians(ellipse.inclination_deg);
  const double phase = core::degrees_to_radians(ellipse.phase_deg);
  const auto counter_clockwise =
      std::polar(1.0, inclination - phase) * (0.5 * (ellipse.major + ellipse.minor));
  const auto clockwise = std::polar(1.0, inclination + phase) * (0.5 * (ellipse.major - ellipse.minor));
  return {counter_clockwise + std::conj(clockwise), -i * (counter_clockwise - std::conj(clockwise))};
}

}  // namespace floeplan::tide
