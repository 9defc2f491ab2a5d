#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/avoidance/carried_forecast.hpp"
#include "engine/avoidance/current_estimate.hpp"
#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/gradient_lines.hpp"
#include "engine/avoidance/guidance.hpp"
#include "engine/avoidance/mission_route.hpp"
#include "engine/avoidance/object_map.hpp"
#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/timed_way.hpp"
#include "engine/avoidance/vertical_room.hpp"
#include "engine/avoidance/water_frame.hpp"

namespace floeplan::avoidance {

/// A detected object for reports and displays. Frame: the flight's local plane; drift over the ground.
struct DetectedObject {
  std::uint32_t id{};
  geo::PlanePoint centre{};  // of the surface seen so far
  core::Metres half_extent{};
  core::Metres place_sigma{};
  geo::VelocityEn drift{};
  core::MetresPerSecond drift_sigma{};  // of the drift through water; over ground add the current's error
  core::Metres keel{};                  // depth of the deepest part seen
  core::Seconds unseen{};

  friend bool operator==(const DetectedObject&, const DetectedObject&) = default;
};

/// Counts of the system's actions so far.
struct AvoidanceCounters {
  std::int64_t evasions{};  // how often the vehicle left the mission's route
  std::int64_t paths_planned{};
  std::int64_t paths_failed{};
  std::int64_t most_expansions{};  // largest number in one search

  friend bool operator==(const AvoidanceCounters&, const AvoidanceCounters&) = default;
};

/// The onboard obstacle avoidance system: object detection, current detection, collision monitoring, and the
/// evasive module with path planning above reactive control (Eichhorn 2009, Figure 3). Its input is the
/// mission's waypoints, the forecast that it carries, and `Sensed` at each step.
///
/// Modes    mission -> path       the route comes too near to an object within `watch`, and a path is known
///          mission, path -> reactive   an object is nearer than `close`, or will be within `imminent` on the
///                                steered course; or evasion is needed and there is no path
///          reactive -> path, mission   nothing was too close for `settled`
///          path, reactive -> mission   the route has been clear for `settled`
///          path, reactive -> given_up  evasion has lasted for `give_up` without getting nearer to the goal;
///                                this mode is final
/// Use      Call `step` for each new state, about once a second. `react` is the reactive loop alone: it does
///          not allocate, and its time is limited. `plan_path` may be called between two calls of it, or
///          never
/// Threads  one at a time
class AvoidanceSystem {
 public:
  /// Errors  std::invalid_argument for settings with violations, and for missing or non-finite waypoints
  AvoidanceSystem(std::vector<geo::PlanePoint> waypoints, CarriedForecast forecast,
                  AvoidanceSettings settings);
  AvoidanceSystem(const AvoidanceSystem&) = delete;
  AvoidanceSystem& operator=(const AvoidanceSystem&) = delete;

  /// `react`, then `plan_path` if a path is wanted. The path is followed from the next step on.
  Guidance step(const Sensed& sensed, const std::stop_token& stop = {});

  /// Takes the sensed data and returns what to do now.
  Guidance react(const Sensed& sensed);
  [[nodiscard]] bool path_wanted() const { return path_wanted_; }
  /// Plans a path from the state of the last `react`. Allocates; limited by the settings' expansions and by
  /// `stop`.
  void plan_path(const std::stop_token& stop = {});

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] const AvoidanceCounters& counters() const { return counters_; }
  [[nodiscard]] std::vector<DetectedObject> objects() const;
  /// Mean current over the depths of the saw-tooth at the vehicle's place.
  [[nodiscard]] EstimatedCurrent current() const { return current_now_; }

 private:
  struct Choice {
    Mode mode;
    Reason reason;
  };

  [[nodiscard]] Guidance guide();
  void perceive(const Sensed& sensed);
  void take_ping(const SonarPing& ping, const OwnState& own);
  [[nodiscard]] TimedWay path_from_here() const;
  [[nodiscard]] Choice choose(bool route_clear, bool path_clear);
  [[nodiscard]] bool is_too_close(const Choice& choice, const TimedWay& route, const TimedWay& path) const;
  [[nodiscard]] bool is_in_vain(const Choice& choice);
  [[nodiscard]] Reason why_in_vain() const;
  [[nodiscard]] Guidance guidance(const Choice& choice, const TimedWay& path);
  void want_path(bool route_clear, bool path_clear);

  AvoidanceSettings settings_;
  CarriedForecast forecast_;
  MissionRoute route_;
  CurrentEstimate current_;
  WaterFrame water_;
  ObjectMap objects_;
  VerticalRoom room_;
  Obstacles obstacles_;
  GradientLines gradient_lines_;
  std::array<Echo, SonarPing::most_returns> echoes_{};
  std::array<VerticalRoom::Pass, SonarPing::most_returns> passes_{};

  OwnState own_{};
  std::optional<core::UtcTime> last_time_{};
  Guidance last_{};
  Going going_{};
  EstimatedCurrent current_now_{};
  TimedWay path_{};
  std::size_t path_point_{};  // index of the path's point steered for
  Mode mode_{Mode::mission};
  Reason why_no_path_{Reason::path_not_ready};
  bool path_wanted_{};
  std::optional<double> planned_s_{};
  std::optional<double> route_clear_since_s_{};
  double close_until_s_{};
  double least_to_go_m_{};
  double in_vain_s_{};  // time of evasion since the vehicle was that near
  std::optional<double> reacted_s_{};
  AvoidanceCounters counters_{};
};

}  // namespace floeplan::avoidance
