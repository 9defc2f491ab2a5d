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

/// Motion of the vehicle: its place in the local plane, its horizontal speed through the water, and the
/// current.
struct Going {
  geo::PlanePoint place{};
  double time_s{};
  double through_water_m_s{};
  geo::VelocityEn current{};
};

/// A place on the planned route.
struct RoutePlace {
  geo::PlanePoint place{};
  std::size_t waypoint{};  // end of the leg
  double along_m{};        // distance along the route from the place abeam of the vehicle
};

/// The mission's waypoints and the progress of the vehicle. Frame: the flight's local plane.
class MissionRoute {
 public:
  /// Errors   std::invalid_argument for no waypoints or one that is not finite
  MissionRoute(std::vector<geo::PlanePoint> waypoints, core::Metres reached_within);

  /// Marks waypoints that are within reach as reached. The first call sets the beginning of the first leg.
  void visit(geo::PlanePoint place);
  /// Marks all waypoints before this one as passed.
  void skip_to(std::size_t waypoint);

  [[nodiscard]] std::size_t next() const { return next_; }
  [[nodiscard]] bool is_done() const { return next_ >= waypoints_.size(); }
  [[nodiscard]] const std::vector<geo::PlanePoint>& waypoints() const { return waypoints_; }
  /// Distance over the remaining legs; zero at the end.
  [[nodiscard]] double to_go_m(geo::PlanePoint place) const;

  /// The way that the mission's autopilot would take from here in the next `horizon_s` seconds.
  [[nodiscard]] TimedWay way(const Going& going, const WaterFrame& water, double horizon_s) const;
  /// The place on the planned legs `along_m` ahead of the place abeam of the vehicle; the last waypoint if
  /// the route is shorter. Empty at the end.
  [[nodiscard]] std::optional<RoutePlace> place_along(geo::PlanePoint abeam_of, double along_m) const;

 private:
  std::vector<geo::PlanePoint> waypoints_;
  double reached_within_m_;
  std::size_t next_{};
  std::optional<geo::PlanePoint> start_{};
};

}  // namespace floeplan::avoidance
