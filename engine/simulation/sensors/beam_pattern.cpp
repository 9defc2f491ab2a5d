#include "engine/simulation/sensors/beam_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floeplan::simulation {
namespace {

constexpr double half_power_at = 1.391557;     // (sin(x) / x)^2 = 1/2
constexpr double one_way_integral = 2.836303;  // of (sin(x) / x)^2 between its first zeros: 2 Si(2 pi)
constexpr double two_way_integral = 2.094395;  // of (sin(x) / x)^4 over all x: 2 pi / 3

/// Argument x of the pattern per sine of the angle from the axis.
double scale_of(double width_rad) { return half_power_at / std::sin(0.5 * width_rad); }

double line_power(double x) {
  if (std::abs(x) >= std::numbers::pi) return 0.0;
  if (std::abs(x) < 1e-6) return 1.0;
  const double amplitude = std::sin(x) / x;
  return amplitude * amplitude;
}

}  // namespace

double beam_power(const BeamPattern& pattern, double across, double up) {
  const double ideal =
      line_power(scale_of(pattern.width_rad) * across) * line_power(scale_of(pattern.height_rad) * up);
  return std::max(ideal, std::pow(10.0, pattern.side_lobes_db / 10.0));
}

double main_lobe_half_width_rad(double width_rad) {
  return std::asin(std::min(1.0, std::numbers::pi / scale_of(width_rad)));
}

double reverberation_angle_sr(const BeamPattern& pattern) {
  return two_way_integral / scale_of(pattern.width_rad) * two_way_integral / scale_of(pattern.height_rad);
}

double directivity_db(const BeamPattern& pattern) {
  const double angle_sr =
      one_way_integral / scale_of(pattern.width_rad) * one_way_integral / scale_of(pattern.height_rad);
  return 10.0 * std::log10(4.0 * std::numbers::pi / angle_sr);
}

}  // namespace floeplan::simulation
