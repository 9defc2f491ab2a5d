#include "engine/planning/timed_route.hpp"

#include <algorithm>

namespace floeplan::planning {

geo::PlanePoint TimedRoute::at(core::Seconds time) const {
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.begin()) return points.front();
  if (next == times.end()) return points.back();
  const auto i = static_cast<std::size_t>(next - times.begin());
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return {points[i - 1].x_m + share * (points[i].x_m - points[i - 1].x_m),
          points[i - 1].y_m + share * (points[i].y_m - points[i - 1].y_m)};
}

std::optional<TimedRoute> time_route(std::vector<geo::PlanePoint> points, core::Seconds depart,
                                     const LegTime& leg_time) {
  TimedRoute route{.points = std::move(points), .times = {depart}};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const auto time = leg_time(route.points[i - 1], route.points[i], route.times.back());
    if (!time) return std::nullopt;
    route.times.push_back(route.times.back() + *time);
  }
  return route;
}

std::vector<geo::PlanePoint> cut_evenly(const TimedRoute& route, std::size_t legs) {
  std::vector<geo::PlanePoint> points;
  for (std::size_t i = 0; i <= legs; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(legs);
    points.push_back(route.at(route.times.front() + share * route.duration()));
  }
  points.back() = route.points.back();
  return points;
}

}  // namespace floeplan::planning
