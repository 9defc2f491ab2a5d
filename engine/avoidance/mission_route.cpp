#include "engine/avoidance/mission_route.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double least_speed_m_s = 0.02;  // over ground; a slower vehicle counts as standing still

bool is_finite_place(geo::PlanePoint p) { return std::isfinite(p.x_m) && std::isfinite(p.y_m); }

}  // namespace

MissionRoute::MissionRoute(std::vector<geo::PlanePoint> waypoints, core::Metres reached_within)
    : waypoints_{std::move(waypoints)}, reached_within_m_{reached_within.value} {
  if (waypoints_.empty()) throw std::invalid_argument{"a mission needs at least one waypoint"};
  if (!std::ranges::all_of(waypoints_, is_finite_place))
    throw std::invalid_argument{"waypoints must be finite"};
}

void MissionRoute::visit(geo::PlanePoint place) {
  if (!start_) start_ = place;
  while (!is_done() && distance_m(place, waypoints_[next_]) <= reached_within_m_) ++next_;
}

void MissionRoute::skip_to(std::size_t waypoint) {
  next_ = std::max(next_, std::min(waypoint, waypoints_.size()));
}

double MissionRoute::to_go_m(geo::PlanePoint place) const {
  double sum_m = 0.0;
  geo::PlanePoint from = place;
  for (std::size_t i = next_; i < waypoints_.size(); ++i) {
    sum_m += distance_m(from, waypoints_[i]);
    from = waypoints_[i];
  }
  return sum_m;
}

TimedWay MissionRoute::way(const Going& going, const WaterFrame& water, double horizon_s) const {
  TimedWay way;
  const double end_s = going.time_s + horizon_s;
  geo::PlanePoint from = going.place;
  double time_s = going.time_s;
  // In the water frame a place on the ground drifts against the current.
  const auto in_water = [&](geo::PlanePoint place, double at_s) {
    const geo::PlanePoint now = water.from_local(place);
    const double since_s = at_s - going.time_s;
    return geo::PlanePoint{now.x_m - since_s * going.current.east.value,
                           now.y_m - since_s * going.current.north.value};
  };
  way.add({in_water(from, time_s), time_s});
  for (std::size_t i = next_; i < waypoints_.size() && time_s < end_s && !way.is_full(); ++i) {
    const double length_m = distance_m(from, waypoints_[i]);
    if (!(length_m > 0.0)) continue;
    const double course = direction_rad(from, waypoints_[i]);
    const Crab crabbed = crab(course, going.current, going.through_water_m_s);
    const double speed = std::max(crabbed.speed_m_s, least_speed_m_s);
    const double reached_s = std::min(time_s + length_m / speed, end_s);
    from = moved(from, course, speed * (reached_s - time_s));
    time_s = reached_s;
    way.add({in_water(from, time_s), time_s});
  }
  return way;
}

std::optional<RoutePlace> MissionRoute::place_along(geo::PlanePoint abeam_of, double along_m) const {
  if (is_done()) return std::nullopt;
  geo::PlanePoint from = next_ > 0 ? waypoints_[next_ - 1] : start_.value_or(abeam_of);
  // The place on the current leg nearest to the vehicle.
  const geo::PlanePoint to = waypoints_[next_];
  const double length_m = distance_m(from, to);
  if (length_m > 0.0) {
    const double share =
        ((abeam_of.x_m - from.x_m) * (to.x_m - from.x_m) + (abeam_of.y_m - from.y_m) * (to.y_m - from.y_m)) /
        (length_m * length_m);
    const double held = std::clamp(share, 0.0, 1.0);
    from = {from.x_m + held * (to.x_m - from.x_m), from.y_m + held * (to.y_m - from.y_m)};
  }
  double left_m = along_m;
  for (std::size_t i = next_; i < waypoints_.size(); ++i) {
    const double leg_m = distance_m(from, waypoints_[i]);
    if (left_m <= leg_m && leg_m > 0.0) {
      const double share = left_m / leg_m;
      return RoutePlace{{from.x_m + share * (waypoints_[i].x_m - from.x_m),
                         from.y_m + share * (waypoints_[i].y_m - from.y_m)},
                        i,
                        along_m};
    }
    left_m -= leg_m;
    from = waypoints_[i];
  }
  return RoutePlace{waypoints_.back(), waypoints_.size() - 1, along_m - left_m};
}

}  // namespace floeplan::avoidance
