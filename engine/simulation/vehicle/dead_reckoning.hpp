#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Errors of the vehicle's navigation sensors. Each flight draws its own errors of compass and speed.
/// Source   together a drift of 6 % of the distance through the water: Claus and Bachmayer 2015,
///          Terrain-aided navigation for an underwater glider, J. Field Robotics 32, doi:10.1002/rob.21563; 2
///          degrees of it from a calibrated compass, the rest from the speed. Fix: 8 m at 95 %, Global
///          Positioning System Standard Positioning Service Performance Standard, 5th edition, 2020, so 3.3 m
///          per component
struct NavigationErrors {
  core::Radians compass{core::degrees_to_radians(2.0)};  // one sigma of a constant error in the flight
  double speed_share{0.05};                              // one sigma of a constant relative speed error
  core::Metres fix{3.3};                                 // standard deviation of each component of each fix
  /// Uncertainty of the current between two fixes; used only for the stated position error.
  core::MetresPerSecond current{0.05};

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The place that the vehicle believes to be at: its fixes, and between them heading and speed integrated,
/// with the current that it measured on the dive before.
/// Current  depth-averaged, computed as a Slocum does: the error of the dead reckoning at the place of
///          surfacing, divided by the time under water. That place is the first fix minus the drift until
///          then, which the next fix gives
/// Source   Merckelbach, Briggs, Smeed and Griffiths 2008, Current measurements from autonomous underwater
///          gliders, IEEE 9th Working Conference on Current Measurement Technology; logs of comet (21 August
///          2019), whose initial estimate lacks the drift and whose final one has it
class DeadReckoning {
 public:
  /// `assumed_current`: current assumed on the first dive, m/s.
  DeadReckoning(const NavigationErrors& errors, Vector fix, Vector assumed_current, bool corrects,
                std::uint64_t seed);

  void dive(core::UtcTime time);
  /// One step under water, with the true heading and the true horizontal speed through the water.
  void advance(double heading_rad, double speed_m_s, core::Seconds step);
  void surface(core::UtcTime time);
  /// A fix at the surface, the first one or a later one. `true_place`: without the error of the fix, which is
  /// added here.
  void fix(Vector true_place, core::UtcTime time);

  [[nodiscard]] Vector place() const { return place_; }
  /// Position error that the vehicle states: one standard deviation of east and of north, in metres.
  [[nodiscard]] double sigma_m(core::UtcTime time) const;
  /// Mean speed through the water on this dive, as the vehicle measures it; empty in its first minute.
  [[nodiscard]] std::optional<double> mean_speed_m_s() const;
  /// Current used for dead reckoning and steering; zero if the mission does not correct for it.
  [[nodiscard]] Vector assumed_current() const { return corrects_ ? current_ : Vector{}; }
  /// The mean current of the last dive, computed from its fixes.
  [[nodiscard]] Vector depth_averaged_current() const { return current_; }
  [[nodiscard]] double measured_heading_rad(double heading_rad) const { return heading_rad + compass_rad_; }

 private:
  NavigationErrors errors_;
  bool corrects_;
  double compass_rad_;
  double speed_factor_;
  std::mt19937_64 rng_;
  Vector place_;
  Vector current_;
  double through_water_m_{};  // distance on this dive, as the vehicle measures it
  core::Seconds under_water_{};
  core::UtcTime dived_{};
  core::UtcTime surfaced_{};
  Vector came_up_at_{};  // by dead reckoning
  Vector reckoned_with_{};
  Vector first_fix_{};
  core::UtcTime first_fix_time_{};
  bool has_first_fix_{};
  bool has_dived_{};
};

}  // namespace floeplan::simulation
