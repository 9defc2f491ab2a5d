#include "engine/avoidance/collision_watch.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::avoidance {
namespace {

constexpr double leave_m = 0.5;

}  // namespace

motion::MovingDisc disc_left_by(const Obstacle& obstacle, geo::PlanePoint place, double now_s, double until_s,
                                double clearance_m) {
  motion::MovingDisc disc = disc_of(obstacle, now_s, until_s, clearance_m);
  const double east_m = place.x_m - disc.centre0.x_m;
  const double north_m = place.y_m - disc.centre0.y_m;
  const double apart_m2 = east_m * east_m + north_m * north_m;
  const double within_m = disc.radius0_m + leave_m;
  if (apart_m2 > within_m * within_m) return disc;  // nearly always, so without a root
  disc.radius0_m = std::max(std::sqrt(apart_m2) - leave_m, 0.0);
  disc.growth_m_s = 0.0;
  return disc;
}

std::optional<double> first_contact(std::span<const TimedPoint> way, std::span<const Obstacle> obstacles,
                                    double clearance_m) {
  if (way.size() < 2) return std::nullopt;
  const double now_s = way.front().time_s;
  std::optional<double> first;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.is_guess) continue;
    const motion::MovingDisc disc =
        disc_left_by(obstacle, way.front().place, now_s, way.back().time_s, clearance_m);
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (first && way[i - 1].time_s >= *first) break;
      const motion::EvenMove move{way[i - 1].place, way[i].place, way[i - 1].time_s, way[i].time_s};
      const auto touch = motion::first_touch(move, disc);
      if (touch && (!first || *touch < *first)) first = touch;
      if (touch) break;
    }
  }
  return first;
}

}  // namespace floeplan::avoidance
