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

/// An object as a report or a display wants it. Frame: the flight's local plane, drift over the ground.
struct DetectedObject {
  std::uint32_t id{};
  geo::PlanePoint centre{};  // of the surface seen so far
  core::Metres half_extent{};
  core::Metres place_sigma{};
  geo::VelocityEn drift{};
  core::MetresPerSecond drift_sigma{};  // through the water; over the ground the current's comes on top
  core::Metres keel{};                  // deepest part seen
  core::Seconds unseen{};

  friend bool operator==(const DetectedObject&, const DetectedObject&) = default;
};

/// What the system did so far.
struct AvoidanceCounters {
  std::int64_t evasions{};  // times that the mission's route was left
  std::int64_t paths_planned{};
  std::int64_t paths_failed{};
  std::int64_t most_expansions{};  // of one search

  friend bool operator==(const AvoidanceCounters&, const AvoidanceCounters&) = default;
};

/// The obstacle avoidance system on board: object detection, sea current detection, collision observation and the
/// evasive module with path planning over reactive control (Eichhorn 2009, Figure 3). It knows its mission's waypoints,
/// the forecast it carries, and what it was told by `Sensed`.
///
/// Modes    mission -> path       the route comes too near to an object within `watch`, and a path is known
///          mission, path -> reactive   an object is nearer than `close`, or will be within `imminent` on the course
///                                steered; or evasion is needed and there is no path
///          reactive -> path, mission   nothing was too close for `settled`
///          path, reactive -> mission   the route has been clear for `settled`
///          path, reactive -> given_up  has evaded for `give_up` and come no nearer to the goal; it stays so
/// Use      `step` once for each new state, about every second. The reactive loop alone is `react`: it does not
///          allocate and its time is bounded. `plan_path` may run between two of them, or not at all
/// Threads  one at a time
class AvoidanceSystem {
 public:
  /// Errors  std::invalid_argument for settings with violations, and for waypoints that are missing or not finite
  AvoidanceSystem(std::vector<geo::PlanePoint> waypoints, CarriedForecast forecast,
                  AvoidanceSettings settings);
  AvoidanceSystem(const AvoidanceSystem&) = delete;
  AvoidanceSystem& operator=(const AvoidanceSystem&) = delete;

  /// `react`, then `plan_path` where one is wanted; the path guides from the next step on.
  Guidance step(const Sensed& sensed, const std::stop_token& stop = {});

  /// Takes what was sensed and says what to do now.
  Guidance react(const Sensed& sensed);
  [[nodiscard]] bool path_wanted() const { return path_wanted_; }
  /// Plans a path from the state last reacted to. Allocates; bounded by the settings' expansions and `stop`.
  void plan_path(const std::stop_token& stop = {});

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] const AvoidanceCounters& counters() const { return counters_; }
  [[nodiscard]] std::vector<DetectedObject> objects() const;
  /// Mean over the depths of the saw-tooth, at the vehicle.
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
  std::size_t path_point_{};  // the one steered for
  Mode mode_{Mode::mission};
  Reason why_no_path_{Reason::path_not_ready};
  bool path_wanted_{};
  std::optional<double> planned_s_{};
  std::optional<double> route_clear_since_s_{};
  double close_until_s_{};
  double least_to_go_m_{};
  double in_vain_s_{};  // of evading since the vehicle was that near
  std::optional<double> reacted_s_{};
  AvoidanceCounters counters_{};
};

}  // namespace floeplan::avoidance
