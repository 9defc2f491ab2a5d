#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/core/units.hpp"
#include "engine/planning/currents/analytic_currents.hpp"

namespace floeplan::support {

/// A way from one bank of a river to the other.
struct RiverCrossing {
  double drift_m;  // displacement along y on the way from bank to bank
  double duration_s;
};

/// The extremal with this constant, by Simpson's rule. The integrand is smooth, so the error falls with the fourth power of
/// the step.
inline RiverCrossing cross(const planning::currents::RiverCurrent& river, double v, double k) {
  constexpr int intervals = 4000;
  const double h = river.width_m / intervals;
  RiverCrossing sum{};
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    const double c = river({std::min(h * i, river.width_m), 0.0}, core::Seconds{0.0})->y_m_s;
    const double sine = k * v / (1.0 - k * c);
    const double cosine = std::sqrt(1.0 - sine * sine);
    sum.drift_m += weight * (c + v * sine) / (v * cosine);
    sum.duration_s += weight / (v * cosine);
  }
  return {sum.drift_m * h / 3.0, sum.duration_s * h / 3.0};
}

/// Least time to cross the river to the point straight opposite, by optimal control. In a flow along y that
/// depends on x alone, Zermelo's equation keeps sin(phi) / (V + c sin(phi)) constant along an extremal. V is
/// the speed through the water, c(x) the current, and phi the heading from the x axis. So sin(phi) = k V / (1
/// - k c(x)), with the constant k for which the vehicle ends at the same y.
/// Accuracy 1e-9 s for the paper's river
/// Errors   std::invalid_argument if the vehicle is not faster than the river's strongest current
/// Source   Zermelo 1931, doi:10.1002/zamm.19310110205; Eichhorn 2009, equation (6)
[[nodiscard]] inline core::Seconds river_crossing_by_optimal_control(
    const planning::currents::RiverCurrent& river, core::MetresPerSecond through_water) {
  const double v = through_water.value;
  if (!(v > river.peak_m_s)) throw std::invalid_argument{"the vehicle must be faster than the river"};

  // The drift grows with k: it is positive for k = 0 (straight heading) and negative near the steepest
  // upstream heading sin(phi) = -1 in the slack water at the banks, k = -1/v.
  double low = -(1.0 - 1e-9) / v;
  double high = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (cross(river, v, middle).drift_m > 0.0 ? high : low) = middle;
  }
  return core::Seconds{cross(river, v, 0.5 * (low + high)).duration_s};
}

}  // namespace floeplan::support
