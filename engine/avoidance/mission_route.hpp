#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/avoidance/timed_way.hpp"
#include "engine/avoidance/water_frame.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::avoidance {

/// How the vehicle moves: its place in the local plane, its horizontal speed through the water, and the current.
struct Going {
  geo::PlanePoint place{};
  double time_s{};
  double through_water_m_s{};
  geo::VelocityEn current{};
};

/// A place on the planned route.
struct RoutePlace {
  geo::PlanePoint place{};
  std::size_t waypoint{};  // the end of its leg
  double along_m{};        // from where the vehicle is abeam of the route
};

/// The mission's waypoint list and how far the vehicle has come in it. Frame: the flight's local plane.
class MissionRoute {
 public:
  /// Errors   std::invalid_argument without waypoints or where one is not finite
  MissionRoute(std::vector<geo::PlanePoint> waypoints, core::Metres reached_within);

  /// Counts waypoints that lie within reach now as reached; the first call sets where the first leg begins.
  void visit(geo::PlanePoint place);
  /// Leaves the waypoints before this one behind.
  void skip_to(std::size_t waypoint);

  [[nodiscard]] std::size_t next() const { return next_; }
  [[nodiscard]] bool is_done() const { return next_ >= waypoints_.size(); }
  [[nodiscard]] const std::vector<geo::PlanePoint>& waypoints() const { return waypoints_; }
  /// Over the remaining legs; zero when done.
  [[nodiscard]] double to_go_m(geo::PlanePoint place) const;

  /// The way that the mission's autopilot would take from here for `horizon_s`.
  [[nodiscard]] TimedWay way(const Going& going, const WaterFrame& water, double horizon_s) const;
  /// The place on the planned legs that lies `along_m` behind the one abeam of the vehicle; the last waypoint when the
  /// route is shorter. Empty when done.
  [[nodiscard]] std::optional<RoutePlace> place_along(geo::PlanePoint abeam_of, double along_m) const;

 private:
  std::vector<geo::PlanePoint> waypoints_;
  double reached_within_m_;
  std::size_t next_{};
  std::optional<geo::PlanePoint> start_{};
};

}  // namespace floeplan::avoidance
