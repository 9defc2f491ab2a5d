#include "engine/planning/planner/alternative_plans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/large_obstacles.hpp"
#include "engine/planning/search/chart.hpp"

namespace floeplan::planning::planner {
namespace {

// Judgements. A scan cell is a hundredth of the distance. An obstacle smaller than a twentieth of it (five
// cells) is left out: to a pilot the routes on both sides of it are one route. Routes of more than twice the
// time are of no use.
constexpr double cells_of_distance = 100.0;
constexpr double least_extent = 0.05;  // of the distance
constexpr double longest_time = 2.0;   // of the given plan's travel time
constexpr std::size_t most_tries = 6;  // each try is a whole plan

/// Length of the straight lines from stop to stop, in metres of the plane.
double distance_m(const std::vector<geo::PlanePoint>& stops) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < stops.size(); ++i) sum_m += geo::distance_m(stops[i - 1], stops[i]);
  return sum_m;
}

TimedRoute timed_route(const Plan& plan, const geo::LocalProjection& projection) {
  TimedRoute route;
  for (const Waypoint& waypoint : plan.waypoints) {
    const geo::PlanePoint point = projection.to_plane(waypoint.place);
    if (!route.points.empty() && route.points.back() == point) continue;
    route.points.push_back(point);
    route.times.push_back(waypoint.eta - plan.departure);
  }
  return route;
}

/// Whether the place lies between the two routes, which have the same start and goal.
bool pass_on_different_sides(const Plan& a, const Plan& b, geo::LonLat place) {
  geo::Polygon between;
  for (const Waypoint& waypoint : a.waypoints) between.outer.push_back(waypoint.place);
  for (auto waypoint = b.waypoints.rbegin(); waypoint != b.waypoints.rend(); ++waypoint)
    between.outer.push_back(waypoint->place);
  return geo::contains(between, place);
}

/// Areas that force a route to the other side of an obstacle: a narrow strip from the obstacle across the
/// given route. For a loose obstacle, which a route might pass through, also its outline.
class Barrier {
 public:
  Barrier(const LargeObstacle& obstacle, geo::PlanePoint end, double width_m) {
    const geo::PlanePoint begin = obstacle.nearest;
    const double length_m = std::max(geo::distance_m(begin, end), 1.0);
    const double across_x_m = -0.5 * width_m * (end.y_m - begin.y_m) / length_m;
    const double across_y_m = 0.5 * width_m * (end.x_m - begin.x_m) / length_m;
    parts_.push_back({{begin.x_m + across_x_m, begin.y_m + across_y_m},
                      {begin.x_m - across_x_m, begin.y_m - across_y_m},
                      {end.x_m - across_x_m, end.y_m - across_y_m},
                      {end.x_m + across_x_m, end.y_m + across_y_m}});
    if (obstacle.is_loose) parts_.push_back(obstacle.outline);
  }

  [[nodiscard]] std::vector<ocean::Zone> zones(const geo::LocalProjection& projection,
                                               const std::string& name) const {
    std::vector<ocean::Zone> result;
    for (const std::vector<geo::PlanePoint>& part : parts_) {
      ocean::Zone zone{.name = name, .kind = ocean::ZoneKind::no_go, .area = {}, .from = {}, .until = {}};
      for (const geo::PlanePoint& point : part) zone.area.outer.push_back(projection.to_lon_lat(point));
      result.push_back(std::move(zone));
    }
    return result;
  }

 private:
  std::vector<std::vector<geo::PlanePoint>> parts_;  // outlines of the areas
};

/// "4 min more", "3 h 05 min less", "the same time", by minutes, as the desk shows durations.
std::string comparison_of(core::Seconds later) {
  if (std::llround(later.count() / 60.0) == 0) return "the same time";
  return core::hours_minutes(core::Seconds{std::abs(later.count())}) +
         (later.count() < 0.0 ? " less" : " more");
}

std::string_view name_of(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::land: return "land";
    case ObstacleKind::shallow_water: return "shallow water";
    case ObstacleKind::icebergs: return "icebergs";
    case ObstacleKind::closed_area: return "closed area";
    case ObstacleKind::no_data: return "area without data";
  }
  return "";
}

/// A plan on the other side of an obstacle.
struct OtherWay {
  Plan plan;
  PlanRequest request;
  const LargeObstacle* around;
};

/// Looks for the alternatives to one plan.
class AlternativeSearch {
 public:
  /// All references are borrowed and must outlive the search.
  AlternativeSearch(const Plan& plan, const Task& task, const search::Chart& chart)
      : plan_{plan},
        task_{task},
        projection_{chart.layout.projection},
        stops_{chart.layout.points},
        distance_m_{distance_m(stops_)},
        scan_{chart.sea.domain().closures(), chart.layout.area(),
              core::Metres{distance_m_ / cells_of_distance}, timed_route(plan, projection_)},
        obstacles_{scan_.of_at_least(core::Metres{least_extent * distance_m_})} {}

  [[nodiscard]] Alternatives find(const Planning& plan_once) const {
    const std::vector<Attempt> attempts = attempts_to_make();
    std::vector<std::optional<OtherWay>> ways(attempts.size());
    core::CountOfEnded ended{[&](std::size_t count) {
      task_.progress("alternatives", static_cast<double>(count) / static_cast<double>(attempts.size()));
    }};
    task_.executor.run(attempts.size(), [&](std::size_t i, bool is_caller) {
      if (!task_.stop.stop_requested()) ways[i] = try_to_plan(attempts[i], plan_once);
      ended.add(is_caller);
    });
    return best_of(std::move(ways), attempts.size());
  }

 private:
  struct Attempt {
    const LargeObstacle* around;
    PlanRequest request;
  };

  /// Obstacles first whose detour is likely to be short.
  [[nodiscard]] std::vector<Attempt> attempts_to_make() const {
    std::vector<const LargeObstacle*> order;
    for (const LargeObstacle& obstacle : obstacles_) order.push_back(&obstacle);
    std::ranges::stable_sort(
        order, {}, [](const LargeObstacle* each) { return each->from_route.value + each->extent.value; });
    std::vector<Attempt> result;
    for (const LargeObstacle* obstacle : order) {
      if (result.size() == most_tries) break;
      const double width_m = 0.5 * distance_m_ / cells_of_distance;
      const Barrier barrier{*obstacle, scan_.beyond_route(*obstacle), width_m};
      PlanRequest request = task_.request;
      request.alternatives = 0;
      bool leaves_stops_open = true;
      for (ocean::Zone& zone : barrier.zones(projection_, "not this way")) {
        for (const geo::PlanePoint& stop : stops_)
          leaves_stops_open = leaves_stops_open && !geo::contains(zone.area, projection_.to_lon_lat(stop));
        request.zones.push_back(std::move(zone));
      }
      if (leaves_stops_open) result.push_back({obstacle, std::move(request)});
    }
    return result;
  }

  [[nodiscard]] std::optional<OtherWay> try_to_plan(const Attempt& attempt, const Planning& plan_once) const {
    Task task = task_.with(attempt.request).as_piece();
    if (task_.request.objective().is_time()) task.of_use = longest_time * plan_.travel_time();
    Result<Plan> plan = plan_once(task);
    const bool is_useful = plan && plan->travel_time() <= longest_time * plan_.travel_time() &&
                           differ(plan_, *plan, *attempt.around);
    if (!is_useful) return std::nullopt;
    return OtherWay{std::move(*plan), attempt.request, attempt.around};
  }

  [[nodiscard]] bool differ(const Plan& a, const Plan& b, const LargeObstacle& obstacle) const {
    return pass_on_different_sides(a, b, projection_.to_lon_lat(obstacle.farthest));
  }
  [[nodiscard]] bool differ(const Plan& a, const Plan& b) const {
    return std::ranges::any_of(obstacles_,
                               [&](const LargeObstacle& obstacle) { return differ(a, b, obstacle); });
  }

  /// The cheapest way if it costs less than the given plan, which it leaves among the ways.
  [[nodiscard]] std::optional<Plan> take_better(std::vector<OtherWay>& ways) const {
    const Objective objective = task_.request.objective();
    if (ways.empty() || !(cost_of(ways.front().plan, objective) < cost_of(plan_, objective)))
      return std::nullopt;
    Plan better = std::exchange(ways.front().plan, plan_);
    ways.front().request = task_.request;
    ways.front().request.alternatives = 0;
    by_cost(ways);
    return better;
  }

  void by_cost(std::vector<OtherWay>& ways) const {
    std::ranges::stable_sort(
        ways, {}, [&](const OtherWay& way) { return cost_of(way.plan, task_.request.objective()); });
  }

  [[nodiscard]] Alternatives best_of(std::vector<std::optional<OtherWay>> tried_ways,
                                     std::size_t tried) const {
    std::vector<OtherWay> ways;
    for (std::optional<OtherWay>& way : tried_ways)
      if (way) ways.push_back(std::move(*way));
    by_cost(ways);
    Alternatives result;
    result.better = take_better(ways);
    const Plan& best = result.better ? *result.better : plan_;
    const auto wanted = static_cast<std::size_t>(task_.request.alternatives);
    for (OtherWay& way : ways) {
      if (result.found.size() == wanted) break;
      const bool is_new =
          differ(best, way.plan) && std::ranges::all_of(result.found, [&](const Alternative& other) {
            return differ(other.plan, way.plan);
          });
      if (!is_new) continue;
      messages::Message reason = reason_of(way, best);
      way.plan.messages.push_back(reason);
      result.found.push_back({std::move(way.plan), std::move(way.request), std::move(reason)});
    }
    if (result.found.size() < wanted) {
      result.fewer = obstacles_.empty()
                         ? messages::plan_message<"nothing-to-go-round">(least_extent * distance_m_ / 1000.0)
                         : messages::plan_message<"few-alternatives">(
                               tried, longest_time * plan_.travel_time().count() / 3600.0);
    }
    return result;
  }

  [[nodiscard]] messages::Message reason_of(const OtherWay& way, const Plan& best) const {
    const geo::LonLat middle = projection_.to_lon_lat(way.around->middle);
    const geo::LonLat passes =
        projection_.to_lon_lat(nearest_point(timed_route(way.plan, projection_), way.around->middle));
    return messages::plan_message<"alternative">(
               geo::compass_point(geo::geodesic_between(middle, passes).course_at_start),
               name_of(way.around->kind), middle.lon_deg, middle.lat_deg, way.around->extent.value / 1000.0,
               comparison_of(way.plan.travel_time() - best.travel_time()))
        .at(middle);
  }

  const Plan& plan_;
  const Task& task_;
  const geo::LocalProjection& projection_;
  const std::vector<geo::PlanePoint>& stops_;
  double distance_m_;
  ObstacleScan scan_;
  std::vector<LargeObstacle> obstacles_;
};

}  // namespace

Alternatives alternatives_to(const Plan& plan, const Task& task, const Planning& plan_once) {
  const auto chart = search::draw_chart(task.environment, task.request, cost::reaches(task.request).back(),
                                        task.stop, &task.shelf, search::Moves::left_out);
  if (!chart) return {};
  return AlternativeSearch{plan, task, *chart}.find(plan_once);
}

}  // namespace floeplan::planning::planner
