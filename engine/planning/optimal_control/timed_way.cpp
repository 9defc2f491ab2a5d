#include "engine/planning/optimal_control/timed_way.hpp"

#include <algorithm>

namespace floeplan::planning::optimal_control {

geo::PlanePoint TimedWay::at(core::Seconds time) const {
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.begin()) return points.front();
  if (next == times.end()) return points.back();
  const auto i = static_cast<std::size_t>(next - times.begin());
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return {points[i - 1].x_m + share * (points[i].x_m - points[i - 1].x_m),
          points[i - 1].y_m + share * (points[i].y_m - points[i - 1].y_m)};
}

std::optional<TimedWay> time_way(std::vector<geo::PlanePoint> points, core::Seconds depart,
                                 const LegTimer& leg_timer) {
  TimedWay way{.points = std::move(points), .times = {depart}};
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const auto time = leg_timer(way.points[i - 1], way.points[i], way.times.back());
    if (!time) return std::nullopt;
    way.times.push_back(way.times.back() + *time);
  }
  return way;
}

std::vector<geo::PlanePoint> cut_evenly(const TimedWay& way, std::size_t legs) {
  std::vector<geo::PlanePoint> points;
  for (std::size_t i = 0; i <= legs; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(legs);
    points.push_back(way.at(way.times.front() + share * way.duration()));
  }
  points.back() = way.points.back();
  return points;
}

}  // namespace floeplan::planning::optimal_control
