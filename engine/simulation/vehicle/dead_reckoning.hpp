#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// How wrong the vehicle's own sensors of place are. Each flight draws its own errors of compass and speed.
/// Source   together a drift of 6 % of the distance through the water: Claus and Bachmayer 2015, Terrain-aided
///          navigation for an underwater glider, J. Field Robotics 32, doi:10.1002/rob.21563; 2 degrees of it a
///          calibrated compass, the rest the speed. Fix: 8 m at 95 %, Global Positioning System Standard Positioning
///          Service Performance Standard, 5th edition, 2020, so 3.3 m of either component
struct NavigationErrors {
  core::Radians compass{core::degrees_to_radians(2.0)};  // one sigma of a bias for the whole flight
  double speed_share{0.05};                              // one sigma of a bias of the speed through the water
  core::Metres fix{3.3};                                 // one sigma of either component of each fix
  /// What the current is not known by between two fixes, for the stated uncertainty alone.
  core::MetresPerSecond current{0.05};

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// Where the vehicle takes itself to be: its fixes, and between them heading and speed summed up with the current that
/// it measured over the dive before.
/// Current  depth-averaged as a Slocum computes it: from the error of the dead reckoning at the place of surfacing over
///          the time under water; that place is the first fix less the drift until then, known from the next fix
/// Source   Merckelbach, Briggs, Smeed and Griffiths 2008, Current measurements from autonomous underwater gliders,
///          IEEE 9th Working Conference on Current Measurement Technology; logs of comet (21 August 2019), whose first
///          estimate lacks the drift and whose final one has it
class DeadReckoning {
 public:
  /// `assumed_current` is what the vehicle takes the water to do on its first dive, m/s.
  DeadReckoning(const NavigationErrors& errors, Vector fix, Vector assumed_current, bool corrects,
                std::uint64_t seed);

  void dive(core::UtcTime time);
  /// One step under water with the true heading and horizontal speed through the water.
  void advance(double heading_rad, double speed_m_s, core::Seconds step);
  void surface(core::UtcTime time);
  /// The first fix after coming up, and any later one: the place is the true one.
  void fix(Vector true_place, core::UtcTime time);

  [[nodiscard]] Vector place() const { return place_; }
  /// Position error that the vehicle states, the same for east and for north: one standard deviation, in metres.
  [[nodiscard]] double sigma_m(core::UtcTime time) const;
  /// Mean speed through the water of this dive, as the vehicle takes it to be; empty in its first minute.
  [[nodiscard]] std::optional<double> mean_speed_m_s() const;
  /// Used to reckon and to steer; still when the mission does not correct for it.
  [[nodiscard]] Vector assumed_current() const { return corrects_ ? current_ : Vector{}; }
  /// The depth-averaged current of the last dive, as computed from its fixes.
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
  double through_water_m_{};  // of this dive, as the vehicle takes it to be
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
