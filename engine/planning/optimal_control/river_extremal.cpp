#include "engine/planning/optimal_control/river_extremal.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace floeplan::planning::optimal_control {
namespace {

struct RiverCrossing {
  double drift_m;  // along y from bank to bank
  double duration_s;
};

/// The extremal with this constant, by Simpson's rule. The integrand is smooth, so the error falls with the fourth power of
/// the step.
RiverCrossing cross(const currents::RiverCurrent& river, double v, double k) {
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

}  // namespace

core::Seconds river_crossing_by_optimal_control(const currents::RiverCurrent& river,
                                                core::MetresPerSecond through_water) {
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

}  // namespace floeplan::planning::optimal_control
