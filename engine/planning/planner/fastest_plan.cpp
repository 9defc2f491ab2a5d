#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/planner/strategy_plans.hpp"
#include "engine/planning/publish/improvement.hpp"
#include "engine/planning/publish/published_plan.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/voyage_grids.hpp"
#include "engine/planning/search/voyage_search.hpp"

namespace floeplan::planning::planner {
namespace {

/// A plan in a search area of one size, its route, and whether a larger area may allow a better plan.
struct Attempt {
  Result<Plan> plan;
  std::optional<search::Chart> chart{};  // empty without a plan
  cost::Route route{};                   // route of the plan
  bool wider_may_help{false};
};

/// Largest possible gain that a message states, as a share of the travel time. A larger bound would only say
/// that the search left out much of the grid, not that a better route is likely. The value is a judgement.
constexpr double most_telling_gain = 0.1;

/// The message for a plan whose search was cut short.
messages::Message what_may_be_better(const Plan& plan) {
  const auto gain = plan.search.possible_gain;
  if (!gain || *gain > most_telling_gain * plan.travel_time())
    return messages::plan_message<"search-cut-short">();
  return messages::plan_message<"search-cut-short-near-the-best">(std::ceil(gain->count() / 60.0),
                                                                  100.0 * (*gain / plan.travel_time()));
}

/// A route along the grids, and the same route after refinement.
struct RefinedWay {
  search::FoundWay found;
  publish::Improved improved;
};

/// Searches the grids and refines the route found.
class WayFinder {
 public:
  /// All references are borrowed and must outlive the finder.
  WayFinder(const search::Chart& chart, const Task& task) : chart_{chart}, task_{task} {
    if (task.request.method != Method::direct)
      grids_ = search::open_grids(chart.sea, chart.layout.grids, task.request.sectors, task.stop);
  }

  [[nodiscard]] Result<RefinedWay> find() const {
    if (!chart_.sea.domain().overhead().bounds_surfacing()) return find_in(chart_.sea, task_.progress);
    // If the best route without the bound keeps the bound, it is also the best with it. Refinement often moves a route out of
    // ice that the grid could not avoid.
    constexpr double share_without_bound = 0.2;  // of the work: a judgement
    const core::ProgressCallback first = core::part_of(task_.progress, "", 0.0, share_without_bound);
    auto free = find_in(chart_.sea.with({.bounds_surfacing = false}), first);
    if (!free || cost::arrivals_along(chart_.sea, free->improved.route.points, cost::at_departure))
      return free;
    return find_in(chart_.sea, core::part_of(task_.progress, "", share_without_bound, 1.0));
  }

 private:
  [[nodiscard]] Result<RefinedWay> find_in(const cost::Sea& sea,
                                           const core::ProgressCallback& progress) const {
    search::FoundWay way;
    way.route = cost::fixed_route(chart_.layout.points);
    if (task_.request.method != Method::direct) {
      const auto report = [&](double fraction) { progress("search", 0.1 + 0.8 * fraction); };
      auto found = search::search_voyage(sea, grids_, task_.request, cost::at_departure, task_.stop, report,
                                         {.of_use = cost::at_departure + task_.of_use});
      if (!found) return tl::unexpected(std::move(found.error()));
      way = std::move(*found);
    }
    progress("refinement", 0.9);
    publish::Improved improved = publish::improve(sea, way.route, task_.request, task_.stop);
    return RefinedWay{std::move(way), std::move(improved)};
  }

  const search::Chart& chart_;
  const Task& task_;
  std::vector<search::OpenGrid> grids_;  // empty for the direct route
};

/// Whether no vehicle could be at the goal earlier, even straight from stop to stop with the strongest
/// current from astern.
bool is_as_early_as_any(const search::Chart& chart, core::Seconds travel_time) {
  constexpr core::Seconds slack{60.0};  // largest error of the end of a hold
  return travel_time <= cost::earliest_arrival(chart.sea, chart.layout.points) + slack;
}

/// Replaces the route by the known one if that passes the same stops, is open and arrives earlier.
void take_if_faster(std::span<const geo::LonLat> known, const search::Chart& chart, cost::Route& route) {
  const std::vector<geo::LonLat>& stops = chart.layout.stops;
  cost::Route other;
  std::size_t passed = 0;
  for (const geo::LonLat place : known) {
    other.points.push_back(chart.layout.projection.to_plane(place));
    other.fixed.push_back(passed < stops.size() && place == stops[passed]);
    if (other.fixed.back()) ++passed;
  }
  if (known.empty() || passed < stops.size()) return;
  const auto of_other = cost::arrivals_along(chart.sea, other.points, cost::at_departure);
  const auto of_route = cost::arrivals_along(chart.sea, route.points, cost::at_departure);
  if (of_other && (!of_route || of_other->back() < of_route->back())) route = std::move(other);
}

/// The steps of planning: search area, search, refinement, published plan.
Attempt plan_within(cost::GridReach reach, const Task& task) {
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  progress("environment", 0.0);
  Result<search::Chart> chart = search::draw_chart(environment, request, reach, stop, &shelf);
  if (!chart) return {.plan = tl::unexpected(std::move(chart.error()))};

  Result<RefinedWay> way = WayFinder{*chart, task}.find();
  if (!way) {
    // If the search was cut short in this area, it would also be cut short in a larger one.
    const bool is_over = way.error().reason == Reason::cancelled || way.error().search_cut_short;
    return {.plan = tl::unexpected(std::move(way.error())), .wider_may_help = !is_over};
  }
  if (stop.stop_requested()) return {.plan = tl::unexpected(search::explain_cancelled(request))};
  take_if_faster(known_route, *chart, way->improved.route);
  Result<Plan> plan =
      publish::publish(*chart, environment, request, way->improved, way->found.statistics, stop);
  if (plan && is_as_early_as_any(*chart, plan->travel_time())) plan->search.none_is_earlier = true;
  if (plan && way->found.statistics.cut_short) {
    plan->messages.push_back(what_may_be_better(*plan));
  }
  return {.plan = std::move(plan),
          .chart = std::move(*chart),
          .route = std::move(way->improved.route),
          .wider_may_help = way->found.touches_rim && !(plan && plan->search.none_is_earlier)};
}

/// The plan in the smaller search area; also in the larger one if that may be better. Each attempt takes one
/// of `parts`.
Attempt best_attempt(const Task& task, core::PartsOfProgress& parts) {
  const std::vector<cost::GridReach> to_try = cost::reaches(task.request);
  const core::ProgressCallback first = parts.next();
  Attempt best = plan_within(to_try.front(), task.telling(first));
  if (best.wider_may_help && to_try.size() > 1) {
    const core::ProgressCallback second = parts.next();
    const Task in_wider_area = task.telling(second);
    Attempt wider = plan_within(to_try.back(), best.plan ? in_wider_area.to_beat(*best.plan) : in_wider_area);
    const bool nearer_will_do = best.plan && (!wider.plan || best.plan->arrival <= wider.plan->arrival);
    if (!nearer_will_do) best = std::move(wider);
  }
  return best;
}

bool search_was_cut_short(const Attempt& attempt) {
  return attempt.plan ? attempt.plan->search.cut_short : attempt.plan.error().search_cut_short;
}

/// Plans on grids of the requested spacing. If the request leaves the spacing open and a search with
/// surfacings was cut short, also on coarser grids, where a search gets further.
Attempt plan_on_grids(const Task& task) {
  const PlanRequest& request = task.request;
  core::PartsOfProgress parts{task.progress, "", core::PartsOfProgress::mostly_one};
  Attempt best = best_attempt(task, parts);
  if (request.under_ice.max_time_without_surfacing && !request.spacing_along && search_was_cut_short(best)) {
    const PlanRequest on_coarser = cost::on_coarser_grids(request);
    Attempt coarse = best_attempt(task.with(on_coarser), parts);
    if (coarse.plan && (!best.plan || coarse.plan->arrival < best.plan->arrival)) best = std::move(coarse);
  }
  if (best.plan) publish::rate(*best.plan, best.chart->sea, request, best.route, task.stop);
  if (task.stop.stop_requested()) best.plan = tl::unexpected(search::explain_cancelled(request));
  return best;
}

/// The request without permission to pass under icebergs; empty if this changes nothing.
std::optional<PlanRequest> without_leave(const ocean::Environment& environment, const PlanRequest& request) {
  if (!request.icebergs.pass_under || environment.icebergs.empty()) return std::nullopt;
  PlanRequest strict = request;
  strict.icebergs.pass_under = false;
  return strict;
}

}  // namespace

Result<Plan> plan_fastest(const Task& task, const Planning&) {
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  const std::optional<PlanRequest> strict = without_leave(environment, request);
  const core::ProgressCallback as_asked = core::part_of(progress, "", 0.0, strict ? 0.5 : 1.0);
  Attempt best = plan_on_grids(task.telling(as_asked));
  if (strict && !stop.stop_requested()) {
    // Permission to pass under icebergs must never delay a plan. But with the permission refinement may end at a
    // slower route. So a plan without the permission is made, too.
    best.chart.reset();  // takes much memory and is no longer needed
    const core::ProgressCallback without_leave_too = core::part_of(progress, "", 0.5, 1.0);
    Attempt without = plan_on_grids(task.with(*strict).telling(without_leave_too));
    if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
    const bool is_no_later = without.plan && (!best.plan || without.plan->arrival <= best.plan->arrival);
    if (is_no_later) best = std::move(without);
  }
  if (best.plan) progress("done", 1.0);
  return std::move(best.plan);
}

}  // namespace floeplan::planning::planner
