#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/avoidance/guidance.hpp"
#include "engine/core/units.hpp"
#include "engine/simulation/flight/flight_path.hpp"
#include "engine/simulation/vehicle/glider_motion.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Runs the mission's behaviours as the vehicle's computer does: which waypoint to steer for, when to turn in the
/// saw-tooth, when to come up and what to do there. Knows only what the vehicle knows.
/// Ends     a mission that cannot go on is aborted, and the vehicle comes up: below the depth or beyond the distance of
///          abend, held at one depth, given up by the system on board. Where ice that the system knows lies above, it
///          looks for a lead for half an hour and then goes back to where it last was at the surface
/// Lists    at the end of a list the vehicle comes up, by the surfacing for it or by an abort for want of a heading;
///          there the pilot sends the next one, where there is one, and the mission begins anew
/// Holds    while the vehicle holds, the pilot sends the next list at the surfacing nearest to the planned end of the
///          hold, and the list of the hold once more where it is flown long before
/// Aim      motion::waypoint_heading
class MissionPilot {
 public:
  enum class Phase { at_surface, diving, climbing, surfacing, done };

  /// What the vehicle knows at a step.
  struct Known {
    core::UtcTime time{};
    Vector place{};  // by dead reckoning or fix; its depth by the pressure sensor
    bool floats{};   // it is at the surface
    std::optional<core::Metres> altitude{};
    Vector current{};  // reckoned with
    double speed_m_s{};
  };
  /// What came of a step, for the record.
  struct Turned {
    bool dived{};
    bool inflected{};
    bool surfaced{};
    bool fixed{};
    std::optional<std::size_t> waypoint{};  // reached, by index
  };

  /// `orders` is borrowed.
  MissionPilot(const MissionOrders& orders, FlightPath path, core::Seconds first_fix, core::UtcTime start);

  Turned step(const Known& known, const avoidance::Guidance& guidance);

  [[nodiscard]] ActuatorTargets targets(const Known& known, const avoidance::Guidance& guidance) const;
  [[nodiscard]] Phase phase() const { return phase_; }
  /// Index of the next stop of the list under way; the number of stops once all are passed.
  [[nodiscard]] std::size_t waypoint() const { return stop_; }
  [[nodiscard]] bool has_finished() const { return stop_ >= path_.stops.size(); }
  /// Whether the mission ended where it was to end: its lists are flown, and the vehicle came up there.
  [[nodiscard]] bool has_arrived() const { return has_finished() && !turns_back_; }
  /// Why the mission ended, once the phase is done.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// Whether mission or guidance ask for the propeller.
  [[nodiscard]] bool uses_thruster(const avoidance::Guidance& guidance) const;

 private:
  Turned at_surface(const Known& known);
  void pass_waypoints(const Known& known, const avoidance::Guidance& guidance, Turned& turned);
  void turn(const Known& known, const avoidance::Guidance& guidance, Turned& turned);
  void seek_surface(const Known& known, bool hit_waypoint);
  void come_up(const SurfaceOrders& orders, std::size_t index, core::UtcTime time);
  void abort(std::string reason);
  void end_hold_in_time(core::UtcTime time);
  /// Whether the list on board is flown.
  [[nodiscard]] bool has_no_heading() const { return has_finished() || awaits_list_; }
  /// Where the vehicle steers for, unless it is guided.
  [[nodiscard]] Vector goal() const;
  [[nodiscard]] bool is_held_at_one_depth(const Known& known);
  void keep_below_ice(const Known& known, const avoidance::Guidance& guidance);
  [[nodiscard]] bool is_due(const SurfaceOrders& orders, std::size_t index, const Known& known,
                            bool hit_waypoint) const;
  [[nodiscard]] const HalfYo& half() const;

  const MissionOrders& orders_;
  FlightPath path_;
  core::Seconds first_fix_;
  Phase phase_{Phase::at_surface};
  std::size_t stop_{};
  bool awaits_list_{};                              // those after `stop_` are not on board yet
  std::optional<core::UtcTime> left_to_hold_{};     // the surface, last
  int halves_{};                                    // done of the yo
  int turns_{};                                     // since the last time up
  bool held_down_{};                                // on the way up, below ice that the system on board knows
  std::optional<core::UtcTime> below_ice_since_{};  // on that way
  bool turns_back_{};                               // to where it last was at the surface
  Vector open_water_{};
  HalfYo climb_{};  // to the surface
  core::Seconds wait_{};
  bool ends_{};
  std::string reason_;
  double held_depth_m_{};  // near it since `held_since_`
  core::UtcTime held_since_{};
  core::UtcTime turned_{};  // last, up or down
  core::UtcTime surfaced_{};
  core::UtcTime fix_due_{};
  core::UtcTime leave_{};
  bool fixed_{true};
  core::UtcTime last_contact_{};
  std::vector<core::UtcTime> began_;  // of each surface behaviour
  std::vector<core::UtcTime> ended_;
  std::optional<std::size_t> running_;  // surface behaviour
};

}  // namespace floeplan::simulation
