#include "engine/planning/time_killing.hpp"

#include <cmath>
#include <cstdio>

#include "engine/planning/loiter.hpp"

namespace floeplan::planning {
namespace {

constexpr core::Seconds worth_telling{600.0};
constexpr std::size_t most_points_between = 64;  // of a route; parts with more are not looked at

/// Time is killed by way: where less than this share of what it would be in still water is added, other things are
/// at work.
constexpr double least_share_of_way = 0.5;

double distance_m(geo::PlanePoint a, geo::PlanePoint b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

}  // namespace

std::optional<TimeKilled> longest_killing_of_time(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                  const Schedule& schedule) {
  if (!sea.has_timed_closures()) return std::nullopt;
  std::vector<double> way_m{0.0};
  for (std::size_t i = 1; i < route.size(); ++i)
    way_m.push_back(way_m.back() + distance_m(route[i - 1], route[i]));
  std::optional<TimeKilled> longest;
  for (std::size_t from = 0; from + 2 < route.size(); ++from) {
    for (std::size_t to = from + 2; to < route.size() && to <= from + most_points_between; ++to) {
      const core::Seconds leaves = schedule.leaves(from);
      const core::Seconds arrives = schedule.arrivals[to];
      const core::Seconds worth = longest ? longest->time : worth_telling;
      const double detour_m = way_m[to] - way_m[from] - distance_m(route[from], route[to]);
      if (detour_m < least_share_of_way * sea.through_water().value * worth.count()) continue;
      const auto straight = sea.leg_time_back(route[from], route[to], arrives, leaves + worth);
      if (!straight || arrives - *straight - leaves <= worth) continue;
      if (can_stay_until(sea, route[from], leaves, arrives - *straight) < arrives - *straight) continue;
      longest = TimeKilled{from, to, arrives - *straight - leaves};
    }
  }
  return longest;
}

std::string describe(const TimeKilled& killed) {
  char text[240];
  std::snprintf(
      text, sizeof text,
      "between waypoints %zu and %zu the way is %.1f h longer than it need be, because what is in the "
      "way opens later: let the vehicle wait (--max-loiter), or depart later",
      killed.from, killed.to, killed.time.count() / 3600.0);
  return text;
}

}  // namespace floeplan::planning
