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

/// Runs the mission's behaviors as the vehicle's computer does: which waypoint to steer for, when to turn in
/// the saw-tooth, when to surface and what to do there. Uses only what the vehicle knows.
/// Ends     A mission that cannot continue is aborted, and the vehicle surfaces: below the depth or beyond
///          the distance of abend, stuck at one depth, or ended by the onboard avoidance. If the avoidance
///          knows ice above, the vehicle searches a lead for half an hour and then returns to its last place
///          at the surface
/// Lists    At the end of a list the vehicle surfaces, by its surfacing behavior or by an abort for lack of a
///          heading. There the pilot sends the next list, if any, and the mission begins anew
/// Holds    During a hold the pilot sends the next list at the surfacing nearest to the hold's planned end,
///          and the hold's list once more if it ends long before
/// Aim      motion::waypoint_heading
class MissionPilot {
 public:
  enum class Phase { at_surface, diving, climbing, surfacing, done };

  /// The values that the vehicle knows at a step.
  struct Known {
    core::UtcTime time{};
    Vector place{};  // by dead reckoning or fix; its depth by the pressure sensor
    bool floats{};   // is at the surface
    std::optional<core::Metres> altitude{};
    Vector current{};  // the assumed current
    double speed_m_s{};
  };
  /// Events of a step, for the record.
  struct Turned {
    bool dived{};
    bool inflected{};
    bool surfaced{};
    bool fixed{};
    std::optional<std::size_t> waypoint{};  // index of a reached waypoint
  };

  /// `orders` is borrowed.
  MissionPilot(const MissionOrders& orders, FlightPath path, core::Seconds first_fix, core::UtcTime start);

  Turned step(const Known& known, const avoidance::Guidance& guidance);

  [[nodiscard]] ActuatorTargets targets(const Known& known, const avoidance::Guidance& guidance) const;
  [[nodiscard]] Phase phase() const { return phase_; }
  /// Index of the next stop; the number of stops once all are passed.
  [[nodiscard]] std::size_t waypoint() const { return stop_; }
  [[nodiscard]] bool has_finished() const { return stop_ >= path_.stops.size(); }
  /// Whether the mission ended as ordered: all lists are flown, and the vehicle surfaced at the end.
  [[nodiscard]] bool has_arrived() const { return has_finished() && !turns_back_; }
  /// Why the mission ended; valid in the phase `done`.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// Whether mission or guidance use the thruster.
  [[nodiscard]] bool uses_thruster(const avoidance::Guidance& guidance) const;

 private:
  Turned at_surface(const Known& known);
  void pass_waypoints(const Known& known, const avoidance::Guidance& guidance, Turned& turned);
  void turn(const Known& known, const avoidance::Guidance& guidance, Turned& turned);
  void seek_surface(const Known& known, bool hit_waypoint);
  void come_up(const SurfaceOrders& orders, std::size_t index, core::UtcTime time);
  void abort(std::string reason);
  void end_hold_in_time(core::UtcTime time);
  /// Whether the list on board has been flown to its end.
  [[nodiscard]] bool has_no_heading() const { return has_finished() || awaits_list_; }
  /// The place that the vehicle steers for, unless guidance overrides it.
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
  bool awaits_list_{};                              // stops after `stop_` are not on board yet
  std::optional<core::UtcTime> left_to_hold_{};     // last departure from the surface during a hold
  int halves_{};                                    // half-yos done
  int turns_{};                                     // turns since the last surfacing
  bool held_down_{};                                // climbing, but held below ice that the avoidance knows
  std::optional<core::UtcTime> below_ice_since_{};  // begin of that time below ice
  bool turns_back_{};                               // returning to the last place at the surface
  Vector open_water_{};
  HalfYo climb_{};  // to the surface
  core::Seconds wait_{};
  bool ends_{};
  std::string reason_;
  double held_depth_m_{};  // depth near which it has stayed since `held_since_`
  core::UtcTime held_since_{};
  core::UtcTime turned_{};  // time of the last turn, up or down
  core::UtcTime surfaced_{};
  core::UtcTime fix_due_{};
  core::UtcTime leave_{};
  bool fixed_{true};
  core::UtcTime last_contact_{};
  std::vector<core::UtcTime> began_;  // last begin of each surface behavior
  std::vector<core::UtcTime> ended_;
  std::optional<std::size_t> running_;  // index of the active surface behavior
};

}  // namespace floeplan::simulation
