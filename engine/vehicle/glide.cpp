#include "engine/vehicle/glide.hpp"

#include <cmath>

#include "engine/vehicle/sea_water.hpp"

namespace floeplan::vehicle {
namespace {

constexpr double steepest_path_rad = 1.5;  // just below vertical, where the tangent becomes infinite
constexpr double scan_step_rad = 0.002;    // a tenth of a degree, much finer than the function's features
constexpr int bisections = 50;             // enough for all digits of a double

/// Lift along the path minus drag: negative if more angle of attack is needed.
double excess_lift(const Hydrodynamics& h, double pitch_rad, double attack_rad) {
  return h.lift_slope * attack_rad * std::tan(pitch_rad + attack_rad) -
         (h.parasite_drag + h.induced_drag * attack_rad * attack_rad);
}

/// The smallest angle of attack at which lift and drag balance; empty: none.
std::optional<double> angle_of_attack(const Hydrodynamics& h, double pitch_rad) {
  double low = 0.0;
  double high = scan_step_rad;
  while (excess_lift(h, pitch_rad, high) < 0.0) {
    low = high;
    high += scan_step_rad;
    if (pitch_rad + high > steepest_path_rad) return std::nullopt;
  }
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (excess_lift(h, pitch_rad, middle) < 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::optional<core::Radians> glide_path_angle(const Hydrodynamics& hydrodynamics, core::Radians pitch) {
  const auto attack = angle_of_attack(hydrodynamics, pitch.value);
  if (!attack) return std::nullopt;
  return core::Radians{pitch.value + *attack};
}

std::optional<SteadyGlide> steady_glide(const Hydrodynamics& hydrodynamics, core::Radians pitch,
                                        core::CubicMetres buoyancy) {
  const auto path = glide_path_angle(hydrodynamics, pitch);
  if (!path) return std::nullopt;

  const double attack_rad = path->value - pitch.value;
  const double drag_area_m2 = hydrodynamics.area_m2 * (hydrodynamics.parasite_drag +
                                                       hydrodynamics.induced_drag * attack_rad * attack_rad);
  // The density cancels: the weight of displaced water drives the vehicle, and the same water resists it.
  const double speed_m_s =
      std::sqrt(2.0 * gravity_m_s2 * buoyancy.value * std::sin(path->value) / drag_area_m2);
  return SteadyGlide{.angle_of_attack = {attack_rad},
                     .path_angle = *path,
                     .horizontal = {speed_m_s * std::cos(path->value)},
                     .vertical = {speed_m_s * std::sin(path->value)}};
}

}  // namespace floeplan::vehicle
