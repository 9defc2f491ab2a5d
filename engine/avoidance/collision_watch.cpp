#include "engine/avoidance/collision_watch.hpp"

#include <algorithm>

#include "engine/avoidance/disc_set.hpp"
#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {

std::optional<double> first_contact(std::span<const TimedPoint> way, std::span<const Obstacle> obstacles,
                                    double clearance_m) {
  if (way.size() < 2 || obstacles.empty()) return std::nullopt;
  LookAhead look{.from = way.front().place,
                 .now_s = way.front().time_s,
                 .until_s = way.back().time_s,
                 .clearance_m = clearance_m,
                 .reach_m = 0.0};
  for (const TimedPoint& point : way)
    look.reach_m = std::max(look.reach_m, distance_m(look.from, point.place));
  const DiscSet discs{obstacles, look};
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto touch = discs.first_touch({way[i - 1].place, way[i].place, way[i - 1].time_s, way[i].time_s});
    if (touch) return touch;
  }
  return std::nullopt;
}

}  // namespace floeplan::avoidance
