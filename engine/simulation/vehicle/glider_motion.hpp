#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/vehicle/true_state.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// What the motion of a hull needs beside its glide: inertia, and how fast its actuators are.
/// Source   mass: comet, a shallow Slocum, by the public record of its trim in July 2019
///          (github.com/smerckel/glidersim). Added masses of a tenth and 1.4 times the mass: Graver 2005, Underwater
///          gliders: dynamics, control and design, Princeton, 5 and 70 kg for a Slocum of 50 kg. Pump and pitch: logs
///          of the inflections of comet (21 August 2019) and amadeus (24 July 2014). Turn: Davis, Eriksen and Jones
///          2002, Autonomous buoyancy-driven underwater gliders, 7 m with the rudder of a Slocum
struct HullMotion {
  double mass_kg{73.3};
  double added_forward_share{0.1};  // of the mass, along the hull
  double added_normal_share{1.4};   // of the mass, across it
  double pump_rate_m3_s{36e-6};     // of the piston, out and in
  core::Seconds pitch_lag{5.0};     // in which the hull follows the shift of its battery
  core::Seconds pitch_time{6.0};    // in which the battery's servo closes in on its target
  double most_pitch_rate_rad_s{0.1};
  core::Metres turn_radius{7.0};  // with the rudder hard over
  core::Seconds yaw_time{5.0};    // in which a turn sets in: three hull lengths at the usual speed
  core::CubicMetres trim{0.0};    // lighter than ballasted for by so much water

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The hull's motion usual for a vehicle of this depth rating. Deep vehicles pump oil, which takes minutes: 4 cm3 a
/// second, an assumption, for no public log was at hand.
[[nodiscard]] HullMotion hull_motion_for(const vehicle::GliderProfile& profile);

/// The vehicle as it is flown: with the parasite drag at which its pump and pitch make the speed that its profile
/// states.
/// Empty where no drag between 0.01 and 2 does.
/// Why     plans count on the speed, which pilots know of each vehicle; of its drag only the order is known. The usual
///         0.15 would make a profile of 0.35 m/s fly 0.31; what it takes instead, 0.12, is what a log of amadeus tells
///         (0.13; one of comet 0.20)
[[nodiscard]] std::optional<vehicle::GliderProfile> flown_vehicle(const vehicle::GliderProfile& profile);

/// What the autopilot's loops ask of the actuators.
struct ActuatorTargets {
  double pitch_rad{};           // nose up positive
  double buoyancy_m3{};         // lighter than neutral positive
  double heading_rad{};         // of the nose, clockwise from the plane's north
  double thruster_speed_m_s{};  // horizontal, through the water; 0: off
};

/// A glider in the water around it: weight and buoyancy, lift and drag at the angle of attack, the inertia of hull and
/// water, the lag of pump, battery and rudder.
/// Laws     held long enough, a pitch and a buoyancy give vehicle::steady_glide; the path of a turn has at least the
///          turn radius
/// Source   Merckelbach, Berger, Krahmann, Dengler and Carpenter 2019, doi:10.1175/JTECH-D-18-0168.1, forces in the
///          upright plane. Differences: lift and drag go with the sine of the angle of attack, so that they stay finite
///          while the vehicle stops to turn round; turns are a lagged rate of the speed over the radius
class GliderMotion {
 public:
  GliderMotion(const vehicle::GliderProfile& profile, const HullMotion& hull, double heading_rad);

  /// One second on. `depth_m` tells the surface, where a buoyant hull lies still.
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
  double buoyancy_m3_{};  // what the pump has moved
  double forward_m_s_{};  // in the direction of the heading, level
  double up_m_s_{};
  double pitch_rate_rad_s_{};
  double yaw_rate_rad_s_{};
  double thrust_n_{};
};

/// The angle turned to within half a turn of zero, in (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle_rad);

}  // namespace floeplan::simulation
