#include "engine/simulation/vehicle/glider_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/messages/fault.hpp"
#include "engine/vehicle/sea_water.hpp"

namespace floeplan::simulation {
namespace {

constexpr double step_s = 1.0;
/// Steps per second: lift turns the path within half a second, so a tenth of a second suffices.
constexpr int parts_of_step = 10;
/// From this heading error on the rudder is hard over; below, it is proportional to the error.
constexpr double full_rudder_error_rad = 0.35;
/// Nearer to the surface the hull floats and rolls; it does not glide.
constexpr double at_surface_m = 0.1;
/// Control gain of the thrust: newtons per second, for each m/s of missing speed.
constexpr double thrust_gain_n_s_m = 2.0;
/// Twice the drag of a Slocum at 1 m/s, which is the stated maximum with thruster.
constexpr double most_thrust_n = 16.0;
constexpr double least_drag = 0.01;
constexpr double most_drag = 2.0;
constexpr int bisections = 50;
constexpr double deepest_piston_m = 350.0;
constexpr double oil_pump_rate_m3_s = 4e-6;

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

}  // namespace

double wrapped_angle(double angle_rad) {
  const double turns = std::round(angle_rad / (2.0 * std::numbers::pi));
  return angle_rad - 2.0 * std::numbers::pi * turns;
}

core::Violations HullMotion::violations() const {
  messages::Faults faults{"/hull/"};
  faults.within(mass_kg, 1.0, 1e4, "mass_kg", "1", "10000 kg");
  faults.within(added_forward_share, 0.0, 5.0, "added_forward_share", "0", "5");
  faults.within(added_normal_share, 0.0, 5.0, "added_normal_share", "0", "5");
  faults.within(pump_rate_m3_s, 1e-7, 1e-2, "pump_rate_cm3_s", "0.1", "10000 cm3/s");
  faults.within(pitch_lag.count(), 0.1, 600.0, "pitch_lag_s", "0.1", "600 s");
  faults.within(pitch_time.count(), 1.0, 600.0, "pitch_time_s", "1", "600 s");
  faults.within(most_pitch_rate_rad_s, 1e-3, 1.0, "pitch_rate_rad_s", "0.001", "1 rad/s");
  faults.within(turn_radius.value, 1.0, 1e4, "turn_radius_m", "1", "10000 m");
  faults.within(yaw_time.count(), 1.0, 600.0, "yaw_time_s", "1", "600 s");
  faults.within(trim.value, -1e-2, 1e-2, "trim_cm3", "-10000", "10000 cm3");
  return faults.found();
}

HullMotion hull_motion_for(const vehicle::GliderProfile& profile) {
  HullMotion hull;
  if (profile.depth_rating.value > deepest_piston_m) hull.pump_rate_m3_s = oil_pump_rate_m3_s;
  return hull;
}

std::optional<vehicle::GliderProfile> flown_vehicle(const vehicle::GliderProfile& profile) {
  vehicle::GliderProfile flown = profile;
  const auto is_too_fast = [&](double drag) {
    flown.hydrodynamics.parasite_drag = drag;
    const auto glide = vehicle::steady_glide(flown.hydrodynamics, flown.pitch, flown.buoyancy);
    return glide && glide->horizontal > profile.speed_through_water;
  };
  double low = least_drag;
  double high = most_drag;
  if (!is_too_fast(low) || is_too_fast(high)) return std::nullopt;
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (is_too_fast(middle) ? low : high) = middle;
  }
  flown.hydrodynamics.parasite_drag = low;
  return flown;
}

GliderMotion::GliderMotion(const vehicle::GliderProfile& profile, const HullMotion& hull, double heading_rad)
    : hydrodynamics_{profile.hydrodynamics}, hull_{hull}, attitude_{.heading_rad = heading_rad} {}

Vector GliderMotion::through_water() const {
  return {forward_m_s_ * std::sin(attitude_.heading_rad), forward_m_s_ * std::cos(attitude_.heading_rad),
          -up_m_s_};
}

void GliderMotion::advance(const ActuatorTargets& targets, double depth_m) {
  buoyancy_m3_ = towards(buoyancy_m3_, targets.buoyancy_m3, hull_.pump_rate_m3_s * step_s);
  // The pump is in the nose, so the hull pitches as water moves in or out. The battery's servo trims the
  // rest.
  const double pumped_share =
      targets.buoyancy_m3 != 0.0 ? std::clamp(buoyancy_m3_ / targets.buoyancy_m3, -1.0, 1.0) : 1.0;
  const double pitch_rate =
      std::clamp((pumped_share * targets.pitch_rad - attitude_.pitch_rad) / hull_.pitch_time.count(),
                 -hull_.most_pitch_rate_rad_s, hull_.most_pitch_rate_rad_s);
  pitch_rate_rad_s_ += (pitch_rate - pitch_rate_rad_s_) * (1.0 - std::exp(-step_s / hull_.pitch_lag.count()));
  attitude_.pitch_rad += pitch_rate_rad_s_ * step_s;

  const bool floats = depth_m <= at_surface_m && buoyancy_m3_ + hull_.trim.value >= 0.0;
  if (floats) {
    forward_m_s_ = 0.0;
    up_m_s_ = 0.0;
    thrust_n_ = 0.0;
    yaw_rate_rad_s_ = 0.0;
    return;
  }
  if (targets.thruster_speed_m_s > 0.0) {
    thrust_n_ += thrust_gain_n_s_m * (targets.thruster_speed_m_s - forward_m_s_) * step_s;
    thrust_n_ = std::clamp(thrust_n_, 0.0, most_thrust_n);
  } else {
    thrust_n_ = 0.0;
  }
  for (int part = 0; part < parts_of_step; ++part) glide(step_s / parts_of_step, thrust_n_);

  const double error_rad = wrapped_angle(targets.heading_rad - attitude_.heading_rad);
  const double rudder = std::clamp(error_rad / full_rudder_error_rad, -1.0, 1.0);
  const double turning_rad_s = rudder * std::max(0.0, forward_m_s_) / hull_.turn_radius.value;
  yaw_rate_rad_s_ += (turning_rad_s - yaw_rate_rad_s_) * (1.0 - std::exp(-step_s / hull_.yaw_time.count()));
  attitude_.heading_rad = wrapped_angle(attitude_.heading_rad + yaw_rate_rad_s_ * step_s);
}

void GliderMotion::glide(double part_s, double thrust_n) {
  const double cp = std::cos(attitude_.pitch_rad);
  const double sp = std::sin(attitude_.pitch_rad);
  const double speed = std::hypot(forward_m_s_, up_m_s_);
  // Directions along the path and perpendicular to it, upwards for a level path.
  const double path_forward = speed > 0.0 ? forward_m_s_ / speed : cp;
  const double path_up = speed > 0.0 ? up_m_s_ / speed : sp;
  const double sine_of_attack = sp * path_forward - cp * path_up;
  const double cosine_of_attack = cp * path_forward + sp * path_up;
  const double pressure_n = 0.5 * vehicle::sea_water_density_kg_m3 * speed * speed * hydrodynamics_.area_m2;
  const double lift_n = pressure_n * hydrodynamics_.lift_slope * sine_of_attack * cosine_of_attack;
  const double drag_n = pressure_n * (hydrodynamics_.parasite_drag +
                                      hydrodynamics_.induced_drag * sine_of_attack * sine_of_attack);
  const double weight_n =
      vehicle::sea_water_density_kg_m3 * vehicle::gravity_m_s2 * (buoyancy_m3_ + hull_.trim.value);
  const double force_forward = -drag_n * path_forward - lift_n * path_up + thrust_n * cp;
  const double force_up = -drag_n * path_up + lift_n * path_forward + weight_n + thrust_n * sp;

  // The added mass of water is smaller along the hull than across it.
  const double along_n = force_forward * cp + force_up * sp;
  const double across_n = -force_forward * sp + force_up * cp;
  const double along = along_n / (hull_.mass_kg * (1.0 + hull_.added_forward_share));
  const double across = across_n / (hull_.mass_kg * (1.0 + hull_.added_normal_share));
  forward_m_s_ += part_s * (along * cp - across * sp);
  up_m_s_ += part_s * (along * sp + across * cp);
}

}  // namespace floeplan::simulation
