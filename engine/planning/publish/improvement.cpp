#include "engine/planning/publish/improvement.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/straightening.hpp"
#include "engine/planning/publish/held_legs.hpp"
#include "engine/planning/publish/holds_for_legs.hpp"
#include "engine/planning/refinement/refinement.hpp"
#include "engine/planning/refinement/refinement_budget.hpp"
#include "engine/planning/refinement/shortening.hpp"

namespace floeplan::planning::publish {
namespace {

bool has_waits(const cost::Schedule& schedule) {
  return std::ranges::any_of(schedule.waits, [](core::Seconds wait) { return wait.count() > 0.0; });
}

std::optional<std::size_t> most_legs(const PlanRequest& request) {
  if (!request.max_waypoints) return std::nullopt;
  return static_cast<std::size_t>(*request.max_waypoints) - 1;
}

std::vector<geo::PlanePoint> stops_of(const cost::Route& way) {
  std::vector<geo::PlanePoint> stops;
  for (std::size_t i = 0; i < way.points.size(); ++i)
    if (way.fixed[i]) stops.push_back(way.points[i]);
  return stops;
}

/// The refined route; `way` is the route along the grid. A closed route is returned unchanged: `publish` says
/// why it is closed.
Improved refined(const cost::Sea& sea, const cost::Route& way, const PlanRequest& request,
                 const std::stop_token& stop) {
  const auto schedule = cost::schedule_along(sea, way.points, cost::at_departure);
  if (!schedule) return {way, std::nullopt};
  const HeldLegs timer{sea, way, *schedule};
  refinement::LegMeter legs{timer, {.stop = stop}};
  const auto on_grid = legs.timed(way, cost::at_departure);
  if (!on_grid) return {way, std::nullopt};
  auto start = on_grid;
  if (!has_waits(*schedule)) {
    const cost::Sea moving = sea.with({.holds = false});
    start = legs.timed(cost::drop_needless_points(moving, way, cost::at_departure, stop), cost::at_departure);
    if (!start) return {way, std::nullopt};
  }
  const auto most = most_legs(request);
  std::vector<cost::Itinerary> shorter;
  if (most)
    shorter = {refinement::shorten_to(legs, *start, *most), refinement::shorten_to(legs, *on_grid, *most)};
  const auto budget = refinement::refinement_budget(request, refinement::timed_legs_per_second, stop);
  const refinement::RefinementLimits limits{.most_legs = most,
                                            .tolerance = request.leg_tolerance,
                                            .least_cost = cost::earliest_arrival(sea, stops_of(way)).count()};
  refinement::Refined result = refinement::refine_route(timer, *start, limits, budget, shorter);
  result.report.before = on_grid->travel_time();
  return {std::move(result.itinerary.route), std::move(result.report)};
}

cost::Route thinned(const cost::Sea& sea, const cost::Route& route, std::size_t most,
                    const std::stop_token& stop) {
  const auto schedule = cost::schedule_along(sea, route.points, cost::at_departure);
  if (!schedule) return route;
  const HeldLegs timer{sea, route, *schedule};
  refinement::LegMeter legs{timer, {.stop = stop}};
  auto timed = legs.timed(route, cost::at_departure);
  return timed ? refinement::shorten_to(legs, std::move(*timed), most).route : route;
}

/// The route with straight legs in place of some of its parts, if the vehicle then arrives no later. If a
/// reopening decides the arrival, refinement leaves detours that a hold makes needless, and one hold is
/// easier to fly than many short ones.
cost::Route with_fewer_points(const cost::Sea& sea, cost::Route route, const std::stop_token& stop) {
  constexpr double as_early = 1e-4;  // as share of the travel time, the tolerance of waits
  const auto schedule = cost::schedule_along(sea, route.points, cost::at_departure);
  if (!schedule) return route;
  const core::Seconds latest = (1.0 + as_early) * (schedule->arrivals.back() - cost::at_departure);
  for (std::size_t from = 0; from + 2 < route.points.size(); ++from) {
    for (std::size_t legs = route.points.size() - 1 - from; legs > 1; legs /= 2) {
      if (stop.stop_requested()) return route;
      const auto begin = static_cast<std::ptrdiff_t>(from) + 1;
      const auto end = static_cast<std::ptrdiff_t>(from + legs);
      const auto fixed_end = route.fixed.begin() + end;
      if (std::find(route.fixed.begin() + begin, fixed_end, true) != fixed_end) continue;
      cost::Route shorter = route;
      shorter.points.erase(shorter.points.begin() + begin, shorter.points.begin() + end);
      shorter.fixed.erase(shorter.fixed.begin() + begin, shorter.fixed.begin() + end);
      const auto then = cost::schedule_along(sea, shorter.points, cost::at_departure);
      if (!then || then->arrivals.back() - cost::at_departure > latest) continue;
      route = std::move(shorter);
      break;
    }
  }
  return route;
}

/// Whether the route is open as a whole. Legs that are open one by one may be closed together: with a limit
/// on the time without surfacing, the ice along other legs is sampled at other places and may add a little
/// time under ice; a vehicle that holds needs a place for it; and a joined leg is integrated in longer
/// pieces, which keep farther from icebergs.
bool stays_open(const cost::Sea& sea, const cost::Route& route) {
  return cost::arrivals_along(sea, route.points, cost::at_departure).has_value();
}

/// Whether the route is open and arrives no later than the other one, apart from the tolerance for fewer
/// legs. A much later route may have had to wait until something reopened.
bool is_as_early(const cost::Sea& sea, const cost::Route& route, const cost::Route& other, double tolerance) {
  const double rounding = std::max(1e-4, tolerance);  // share of times: at least the tolerance of waits
  const auto arrivals = cost::arrivals_along(sea, route.points, cost::at_departure);
  if (!arrivals || !cost::holds_may_help(sea)) return arrivals.has_value();
  const auto others = cost::arrivals_along(sea, other.points, cost::at_departure);
  return !others || arrivals->back() <= (1.0 + rounding) * others->back();
}

/// The route with more fixed points: where it leaves the ice and where it goes below it. Moves of other
/// points then do not change the places to surface, and can only shorten the time without surfacing.
cost::Route held_at_the_ice(const cost::Sea& sea, const cost::Route& route) {
  const auto schedule = cost::schedule_along(sea, route.points, cost::at_departure);
  if (!schedule) return route;
  cost::Route held{{route.points.front()}, {true}};
  const auto add = [&](geo::PlanePoint point, bool fixed) {
    const geo::PlanePoint last = held.points.back();
    if (last.x_m == point.x_m && last.y_m == point.y_m) {
      held.fixed.back() = held.fixed.back() || fixed;
    } else {
      held.points.push_back(point);
      held.fixed.push_back(fixed);
    }
  };
  bool was_open = sea.domain().overhead().may_surface(route.points.front(), schedule->leaves(0));
  for (std::size_t i = 0; i < route.legs(); ++i) {
    const geo::PlanePoint end = route.points[i + 1];
    geo::PlanePoint before = route.points[i];
    for (const cost::Sea::Passage& passage :
         sea.passages(route.points[i], end, schedule->leaves(i), sea.domain().overhead().look(),
                      sea.drives().front())) {
      const bool is_open = sea.domain().overhead().may_surface(passage.point, passage.time);
      if (is_open != was_open) add(is_open ? passage.point : before, true);
      was_open = is_open;
      before = passage.point;
    }
    add(end, route.fixed[i + 1]);
  }
  return held;
}

/// Undoes `held_at_the_ice`: only the points that are fixed in `way` stay fixed.
cost::Route released(cost::Route route, const cost::Route& way) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    const auto is_at = [&](std::size_t j) {
      return way.points[j].x_m == route.points[i].x_m && way.points[j].y_m == route.points[i].y_m;
    };
    if (!route.fixed[i]) continue;
    std::size_t same = next;
    while (same < way.points.size() && !is_at(same)) ++same;
    route.fixed[i] = same < way.points.size() && way.fixed[same];
    if (same < way.points.size()) next = same + 1;
  }
  return route;
}

/// The route with consecutive legs of the same direction joined, if it stays open; otherwise unchanged.
cost::Route joined_where_open(const cost::Sea& sea, const cost::Route& way) {
  cost::Route joined = cost::join_collinear(way);
  for (std::size_t most = std::bit_floor(way.legs()); most > 1 && !stays_open(sea, joined); most /= 2)
    joined = cost::join_collinear(way, most);
  return stays_open(sea, joined) ? joined : way;
}

/// The steps after refinement.
cost::Route finished(const cost::Sea& sea, cost::Route route, const PlanRequest& request,
                     const std::stop_token& stop) {
  if (request.refine && cost::holds_may_help(sea)) route = with_fewer_points(sea, std::move(route), stop);
  // Refinement has already reduced the number of legs. If it could not, this removal cannot either.
  if (const auto most = most_legs(request)) route = thinned(sea, route, *most, stop);
  if (request.max_leg) route = cost::part_long_legs(sea.domain(), route, *request.max_leg);
  return route;
}

}  // namespace

Improved improve(const cost::Sea& sea, const cost::Route& way, const PlanRequest& request,
                 const std::stop_token& stop) {
  Improved improved{way, std::nullopt};
  if (request.method != Method::direct) {
    improved.route = joined_where_open(sea, way);
    if (request.refine) improved = refined(sea, improved.route, request, stop);
  }
  improved.route = finished(sea, improved.route, request, stop);
  if (request.max_waypoints ? stays_open(sea, improved.route)
                            : is_as_early(sea, improved.route, way, request.leg_tolerance)) {
    if (request.refine && request.leg_tolerance > 0.0 && !request.max_leg)
      improved.route = with_holds_for_short_legs(sea, std::move(improved.route), stop);
    return improved;
  }
  const cost::Route joined = joined_where_open(sea, way);
  if (request.refine && request.method != Method::direct && sea.domain().overhead().bounds_surfacing()) {
    Improved held = refined(sea, held_at_the_ice(sea, joined), request, stop);
    held.route = finished(sea, released(std::move(held.route), joined), request, stop);
    if (stays_open(sea, held.route)) return held;
  }
  const cost::Route straightened =
      request.refine ? cost::drop_needless_points(sea, joined, cost::at_departure, stop) : joined;
  if (request.max_leg) {
    for (const cost::Route& route : {straightened, way}) {
      const cost::Route parted = cost::part_long_legs(sea.domain(), route, *request.max_leg);
      if (stays_open(sea, parted)) return {parted, std::nullopt};
    }
  }
  return {stays_open(sea, straightened) ? straightened : way, std::nullopt};
}

}  // namespace floeplan::planning::publish
