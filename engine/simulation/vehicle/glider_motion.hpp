#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/vehicle/true_state.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// Parameters of the hull's motion besides its glide: inertia, and speed of the actuators.
/// Source   mass: comet, a shallow Slocum, by the public record of its trim in July 2019
///          (github.com/smerckel/glidersim). Added masses of a tenth and 1.4 times the mass: Graver 2005, Underwater
///          gliders: dynamics, control and design, Princeton, 5 and 70 kg for a Slocum of 50 kg. Pump and pitch: logs
///          of the inflections of comet (21 August 2019) and amadeus (24 July 2014). Turn: Davis, Eriksen and Jones
///          2002, Autonomous buoyancy-driven underwater gliders, 7 m with the rudder of a Slocum
struct HullMotion {
  double mass_kg{73.3};
  double added_forward_share{0.1};  // added mass along the hull, as a share of the mass
  double added_normal_share{1.4};   // added mass across the hull, as a share of the mass
  double pump_rate_m3_s{36e-6};     // volume per time, in both directions
  core::Seconds pitch_lag{5.0};     // lag of the hull behind the battery's position
  core::Seconds pitch_time{6.0};    // time constant of the battery's servo
  double most_pitch_rate_rad_s{0.1};
  core::Metres turn_radius{7.0};  // with the rudder hard over
  core::Seconds yaw_time{5.0};    // time constant of the yaw rate: three hull lengths at the usual speed
  core::CubicMetres trim{0.0};    // excess buoyancy over the ballasting, as volume of water

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The usual motion parameters for a vehicle of this depth rating. Deep vehicles pump oil, which takes
/// minutes: 4 cm3/s, an assumption, because no public log was found.
[[nodiscard]] HullMotion hull_motion_for(const vehicle::GliderProfile& profile);

/// The vehicle as simulated: with the parasite drag for which its pump and pitch give the speed in its
/// profile. Empty if no drag between 0.01 and 2 does.
/// Why     plans use the speed, which pilots know for each vehicle; its drag is known only roughly. The usual
///         0.15 would make a profile of 0.35 m/s fly at 0.31. The value found, 0.12, agrees with a log of
///         amadeus (0.13; one of comet gave 0.20)
[[nodiscard]] std::optional<vehicle::GliderProfile> flown_vehicle(const vehicle::GliderProfile& profile);

/// Set points of the autopilot for the actuators.
struct ActuatorTargets {
  double pitch_rad{};           // nose up positive
  double buoyancy_m3{};         // above neutral positive
  double heading_rad{};         // of the nose, clockwise from the plane's north
  double thruster_speed_m_s{};  // horizontal, through the water; 0: off
};

/// A glider in the water around it: weight and buoyancy, lift and drag at the angle of attack, inertia of
/// hull and water, lag of pump, battery and rudder.
/// Laws     constant pitch and buoyancy lead to vehicle::steady_glide; the turn radius is never below
///          `turn_radius`
/// Source   Merckelbach, Berger, Krahmann, Dengler and Carpenter 2019, doi:10.1175/JTECH-D-18-0168.1, forces
///          in the vertical plane. Differences: lift and drag depend on the sine of the angle of attack, so
///          that they stay finite when the vehicle stops to turn; the yaw rate is the lagged quotient of
///          speed and radius
class GliderMotion {
 public:
  GliderMotion(const vehicle::GliderProfile& profile, const HullMotion& hull, double heading_rad);

  /// Advances by one second. `depth_m` shows whether the vehicle is at the surface, where a buoyant hull lies
  /// still.
  void advance(const ActuatorTargets& targets, double depth_m);

  [[nodiscard]] const Attitude& attitude() const { return attitude_; }
  /// Velocity through the water in the frame of the flight, m/s.
  [[nodiscard]] Vector through_water() const;
  [[nodiscard]] double horizontal_m_s() const { return forward_m_s_; }
  [[nodiscard]] double sinking_m_s() const { return -up_m_s_; }
  [[nodiscard]] double buoyancy_m3() const { return buoyancy_m3_; }

 private:
  void glide(double step_s, double thrust_n);

  vehicle::Hydrodynamics hydrodynamics_;
  HullMotion hull_;
  Attitude attitude_;
  double buoyancy_m3_{};  // volume that the pump has moved
  double forward_m_s_{};  // horizontal, in the direction of the heading
  double up_m_s_{};
  double pitch_rate_rad_s_{};
  double yaw_rate_rad_s_{};
  double thrust_n_{};
};

/// The angle wrapped to (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle_rad);

}  // namespace floeplan::simulation
