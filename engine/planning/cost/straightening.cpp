#include "engine/planning/cost/straightening.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"

namespace floeplan::planning::cost {
namespace {

/// Arrival at the point after `i` if point `i` is left out, for a departure at `depart` from the point before
/// `i`.
std::optional<core::Seconds> arrival_without(const Sea& sea, const Route& route, std::size_t i,
                                             core::Seconds depart) {
  const auto time = time_with_wait(sea, route.points[i - 1], route.points[i + 1], depart);
  if (!time) return std::nullopt;
  return depart + *time;
}

void erase(Route& route, std::size_t i) {
  route.points.erase(route.points.begin() + static_cast<std::ptrdiff_t>(i));
  route.fixed.erase(route.fixed.begin() + static_cast<std::ptrdiff_t>(i));
}

/// Whether the rest of the route stays open without point `i`. An earlier arrival may meet a closure that the
/// vehicle was late enough to miss. If the time without surfacing is limited, whether a leg is open depends
/// on the legs before it.
bool still_passable(const Sea& sea, const Route& route, std::size_t i, core::Seconds depart) {
  Route shorter = route;
  erase(shorter, i);
  return arrivals_along(sea, shorter.points, depart).has_value();
}

}  // namespace

Route join_collinear(const Route& route, std::size_t most) {
  constexpr double straight =
      1e-9;  // sine of a turn that counts as none: only rounding of grid coordinates is smaller
  Route result;
  std::size_t joined = 1;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    if (joined < most && i > 0 && i + 1 < route.points.size() && !route.fixed[i]) {
      const geo::PlanePoint before = result.points.back();
      const geo::PlanePoint here = route.points[i];
      const geo::PlanePoint after = route.points[i + 1];
      const double ax = here.x_m - before.x_m;
      const double ay = here.y_m - before.y_m;
      const double bx = after.x_m - here.x_m;
      const double by = after.y_m - here.y_m;
      const bool same_way = ax * bx + ay * by > 0.0;
      if (same_way && std::abs(ax * by - ay * bx) <= straight * std::hypot(ax, ay) * std::hypot(bx, by)) {
        ++joined;
        continue;
      }
    }
    joined = 1;
    result.points.push_back(route.points[i]);
    result.fixed.push_back(route.fixed[i]);
  }
  return result;
}

Route drop_needless_points(const Sea& sea, const Route& route, core::Seconds depart,
                           const std::stop_token& stop) {
  Route result = route;
  bool changed = true;
  while (changed) {
    changed = false;
    core::Seconds now = depart;
    for (std::size_t i = 1; i + 1 < result.points.size();) {
      if (stop.stop_requested()) return result;
      const auto to_here = time_with_wait(sea, result.points[i - 1], result.points[i], now);
      const auto onward =
          to_here ? time_with_wait(sea, result.points[i], result.points[i + 1], now + *to_here) : to_here;
      if (!onward) return result;  // a closed route is returned unchanged
      const auto without = result.fixed[i] ? std::nullopt : arrival_without(sea, result, i, now);
      if (without && *without <= now + *to_here + *onward && still_passable(sea, result, i, depart)) {
        erase(result, i);
        changed = true;
      } else {
        now += *to_here;
        ++i;
      }
    }
  }
  return result;
}

Route part_long_legs(const PlanningDomain& domain, const Route& route, core::Metres longest) {
  Route result{{route.points.front()}, {route.fixed.front()}};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const geo::PlanePoint from = route.points[i - 1];
    const geo::PlanePoint to = route.points[i];
    // The scale of the plane varies along a leg, so equal parts in the plane differ slightly on the ground:
    // one part more may be needed.
    int parts =
        std::max(1, static_cast<int>(std::ceil(domain.lengths().between(from, to).value / longest.value)));
    const auto at = [&](int part) {
      const double share = static_cast<double>(part) / parts;
      return geo::PlanePoint{from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)};
    };
    const auto too_long = [&](int part) {
      return domain.lengths().between(at(part - 1), at(part)) > longest;
    };
    while (parts > 1 && (too_long(1) || too_long(parts))) ++parts;
    for (int part = 1; part < parts; ++part) {
      result.points.push_back(at(part));
      result.fixed.push_back(false);
    }
    result.points.push_back(to);
    result.fixed.push_back(route.fixed[i]);
  }
  return result;
}

}  // namespace floeplan::planning::cost
