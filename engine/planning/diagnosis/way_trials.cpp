#include "engine/planning/diagnosis/way_trials.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/publish/improvement.hpp"
#include "engine/planning/publish/published_plan.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/holding/hold_anywhere.hpp"
#include "engine/planning/search/holding/hold_search.hpp"
#include "engine/planning/search/surfacing/surfacing_search.hpp"

namespace floeplan::planning::diagnosis {
namespace {

// Work of each item in units of a timed leg, measured on the demonstration data.
constexpr std::int64_t work_of_a_leg = 6;
constexpr std::int64_t work_of_a_label = 600;   // all legs out of it
constexpr std::int64_t work_of_a_berg = 2000;   // forecast of its drift
constexpr double work_of_a_vertex = 10.0;       // its share of the maps, and the test of its edges
constexpr double work_of_a_value = 1.0 / 50.0;  // one value of the currents, averaged over the dive depths
constexpr double work_of_a_node = 2.0;          // one node of a lookup table of the data
constexpr std::size_t most_labels_of_a_trial = 100'000;

/// Bound by the least possible remaining time: the search finds the earliest route.
struct TowardsEarliestWay {
  search::ForesightBound foresight;
  core::Seconds arrive;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart) const {
    return foresight.least_time(edge, depart);
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return foresight.remaining(v); }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const { return foresight.latest_use(v); }
};

/// Guided by the approximate remaining time. The search quickly finds some route, but not the earliest one,
/// because the remaining time depends on the time of day. If little time is left, it may miss a route.
struct TowardsAnyWay : TowardsEarliestWay {
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return arrive - latest_use(v); }
};

/// Result of the search over one grid: the route and its arrival at the goal.
struct Reached {
  std::vector<geo::PlanePoint> path;  // empty: no route was found
  core::Seconds since_surfacing{};
};

/// The search for any route over one grid, with the same steps by which the planner looks for the best one.
class GridTrial {
 public:
  /// `left`: remaining work; below zero once used up. All references are borrowed and must outlive the trial.
  GridTrial(const cost::Sea& sea, const search::OpenGrid& open, std::int64_t& left,
            const std::stop_token& stop)
      : sea_{sea}, open_{open}, left_{left}, stop_{stop}, foresight_{sea, open} {}

  Reached operator()(core::Seconds depart, core::Seconds since_surfacing) {
    std::vector<geo::PlanePoint> path = unbounded_way(depart);
    if (!sea_.domain().overhead().bounds_surfacing() || path.empty()) return {std::move(path), {}};
    constexpr core::Seconds whenever_there{INFINITY};
    if (const auto since = cost::since_surfacing_at_end(sea_, path, depart, since_surfacing, whenever_there))
      return {std::move(path), *since};
    return with_surfacings(depart, since_surfacing);
  }

 private:
  using TimedClosures = search::Foresight::TimedClosures;

  /// Finds a route without regard to the limit on the time without surfacing.
  std::vector<geo::PlanePoint> unbounded_way(core::Seconds depart) {
    const auto untimed = [this](const graph::Edge& edge, core::Seconds leaves, core::Seconds latest) {
      return sea_.leg_time_without_timed_closures(open_.grid.point(edge.tail), open_.grid.point(edge.head),
                                                  leaves, latest);
    };
    const search::GridTravelTime timed{sea_, open_.grid};
    if (cost::holds_may_help(sea_)) return way_with_holds(depart);
    if (!sea_.domain().closures().any_timed()) return likely_or_earliest_way(depart, timed).path;

    Way way = likely_or_earliest_way(depart, untimed);
    if (way.path.empty() || cost::schedule_along(sea_, way.path, depart)) return std::move(way.path);
    // Detours round an obstacle are seldom longer than this factor. Places that cannot be on such a detour
    // are not checked.
    constexpr double detour = 1.25;
    const core::Seconds soon = depart + detour * (way.arrival - depart);
    way = way_by<TowardsAnyWay>(depart, soon, timed);
    if (way.path.empty()) way = way_by<TowardsEarliestWay>(depart, whenever, timed);
    return std::move(way.path);
  }

  [[nodiscard]] std::size_t affordable_labels() const {
    const auto affordable = static_cast<std::size_t>(std::max<std::int64_t>(1, left_ / work_of_a_label));
    return std::min(most_labels_of_a_trial, affordable);
  }

  Reached with_surfacings(core::Seconds depart, core::Seconds since_surfacing) {
    const std::size_t affordable = std::max<std::size_t>(1, affordable_labels() / 3);
    search::RouteSearch found = search::search_with_surfacings(sea_, open_, depart, since_surfacing, stop_,
                                                               [](double) {}, {affordable, affordable});
    left_ -= work_of_a_leg * found.statistics.edge_evaluations;
    if (found.statistics.cut_short) left_ = std::min<std::int64_t>(left_, 0);
    return {std::move(found.path), found.since_surfacing};
  }

  struct Way {
    std::vector<geo::PlanePoint> path;  // empty: no route
    core::Seconds arrival{};
  };
  static constexpr core::Seconds whenever{INFINITY};

  /// Times legs while work is left. After that every leg counts as closed, so the search ends.
  template <class LegTimes>
  auto rationed(const LegTimes& leg_times) {
    return [this, &leg_times](const graph::Edge& edge, core::Seconds leaves,
                              core::Seconds latest) -> tl::expected<core::Seconds, motion::EdgeClosed> {
      if (left_ <= 0) return tl::unexpected(motion::EdgeClosed::too_late);
      left_ -= work_of_a_leg;
      return leg_times(edge, leaves, latest);
    };
  }

  /// The probably best route if it is open, otherwise the earliest one. Closures that end do not count.
  template <class LegTimes>
  Way likely_or_earliest_way(core::Seconds depart, const LegTimes& leg_times) {
    if (foresight_.is_useful()) {
      Way way = likely_way(depart, leg_times, TimedClosures::ignored);
      if (!way.path.empty()) return way;
    }
    return way_by<TowardsEarliestWay>(depart, whenever, leg_times);
  }

  /// `timed`: how the times of legs treat closures that end
  template <class LegTimes>
  Way likely_way(core::Seconds depart, const LegTimes& leg_times, TimedClosures timed) {
    const auto times = rationed(leg_times);
    Way way{.path = {open_.grid.point(open_.grid.start)}, .arrival = depart};
    const std::vector<graph::Edge> edges = foresight_.likely_way(depart, stop_, {.timed = timed});
    for (const graph::Edge& edge : edges) {
      const auto time = times(edge, way.arrival, whenever);
      if (!time) return {};
      way.path.push_back(open_.grid.point(edge.head));
      way.arrival += *time;
    }
    return edges.empty() ? Way{} : way;
  }

  /// A route that reaches the goal by `latest`.
  template <class Bound, class LegTimes>
  Way way_by(core::Seconds depart, core::Seconds latest, const LegTimes& leg_times) {
    const graph::SearchTree tree = arrivals_by<Bound>(depart, latest, rationed(leg_times));
    Way way;
    for (const graph::Vertex v : graph::path_to(open_.graph, tree, open_.grid.goal))
      way.path.push_back(open_.grid.point(v));
    way.arrival = core::Seconds{tree.arrival_s(open_.grid.goal)};
    return way;
  }

  /// Whether closures that never end stand between start and goal, on every route of the grid.
  bool is_walled_off() {
    if (walled_off_) return *walled_off_;
    const search::StraightBound straight{sea_, open_.grid, open_.graph, open_.grid.goal};
    const search::StandingTravelTime least{sea_, open_.grid, straight};
    const graph::Query query{open_.grid.start, open_.grid.goal, core::Seconds{0.0}, whenever};
    const auto tree = graph::find_earliest_arrivals(open_.graph, query, rationed(least), stop_, straight);
    walled_off_ = !tree.is_reached(open_.grid.goal);
    return *walled_off_;
  }

  template <class Bound, class TravelTime>
  graph::SearchTree arrivals_by(core::Seconds depart, core::Seconds latest, const TravelTime& travel_time) {
    if (is_walled_off()) return graph::SearchTree{open_.graph.size()};
    const search::StraightBound straight{sea_, open_.grid, open_.graph, open_.grid.goal};
    const graph::Query query{open_.grid.start, open_.grid.goal, depart, latest};
    // Nothing is open beyond the end of the data, so places from which the goal cannot be reached by then are
    // skipped.
    const auto end = sea_.domain().currents() ? sea_.domain().currents()->end() : std::nullopt;
    const core::Seconds last = std::min(latest, end.value_or(latest));
    if (!std::isfinite(last.count()) || !foresight_.is_useful())
      return graph::find_earliest_arrivals(open_.graph, query, travel_time, stop_, straight);
    const graph::SearchTree& until_when = foresight_.until_when_of_use(depart, last, stop_);
    const Bound bound{
        TowardsEarliestWay{{foresight_, foresight_.at_any_time(stop_).to_goal, until_when}, last}};
    if (bound.latest_use(open_.grid.start) < depart) return graph::SearchTree{open_.graph.size()};
    return graph::find_earliest_arrivals(open_.graph, query, travel_time, stop_, bound);
  }

  /// A route with holds, or a route without holds if a hold would be longer than allowed.
  std::vector<geo::PlanePoint> way_with_holds(core::Seconds depart) {
    const core::Metres straight{
        geo::distance_m(open_.grid.point(open_.grid.start), open_.grid.point(open_.grid.goal))};
    const search::HoldAnywhereTime held_anywhere{sea_, open_.grid, foresight_,
                                                 cost::end_of_looks(sea_, depart, straight)};
    const auto is_possible = [&](const Way& way) {
      return !way.path.empty() && cost::schedule_along(sea_, way.path, depart).has_value();
    };
    if (foresight_.is_useful()) {
      Way likely = likely_way(depart, held_anywhere, TimedClosures::waited_for);
      if (is_possible(likely)) return std::move(likely.path);
    }
    Way earliest = way_by<TowardsEarliestWay>(depart, whenever, held_anywhere);
    if (is_possible(earliest)) return std::move(earliest.path);
    if (is_walled_off()) return {};
    search::HeldWay held = search::search_held_way(
        sea_, open_, foresight_, depart, whenever, stop_, {},
        {.most_entries = search::limits_of_a_hold_search.most_entries,
         .most_looks = std::min(search::limits_of_a_hold_search.most_looks,
                                left_ / (work_of_a_leg * search::leg_times_of_a_look))});
    left_ -= work_of_a_leg * held.leg_times;
    if (held.full) left_ = std::min<std::int64_t>(left_, 0);
    if (!held.path.empty() || left_ <= 0) return std::move(held.path);
    const cost::Sea moving = sea_.with({.holds = false});
    return GridTrial{moving, open_, left_, stop_}.unbounded_way(depart);
  }

  const cost::Sea& sea_;
  const search::OpenGrid& open_;
  std::int64_t& left_;
  const std::stop_token& stop_;
  search::Foresight foresight_;
  std::optional<bool> walled_off_;
};

/// The route from stop to stop; empty if there is none, or no work is left to find one.
std::optional<cost::Route> search_all(const cost::Sea& sea, const std::vector<cost::RouteGrid>& grids,
                                      int sectors, std::int64_t& left, const std::stop_token& stop) {
  cost::Route route;
  core::Seconds now{0.0};
  core::Seconds since_surfacing{0.0};
  for (const cost::RouteGrid& grid : grids) {
    const search::OpenGrid open = search::open_grid(sea.domain(), grid, sectors, stop);
    if (route.points.empty()) {
      route.points.push_back(grid.point(grid.start));
      route.fixed.push_back(true);
    }
    const Reached reached = GridTrial{sea, open, left, stop}(now, since_surfacing);
    if (reached.path.empty()) return std::nullopt;
    const auto arrivals = cost::arrivals_along(sea, reached.path, now, since_surfacing);
    if (!arrivals) return std::nullopt;
    now = arrivals->back();
    since_surfacing = reached.since_surfacing;
    for (std::size_t i = 1; i < reached.path.size(); ++i) {
      route.points.push_back(reached.path[i]);
      route.fixed.push_back(i + 1 == reached.path.size());
    }
  }
  return route;
}

/// Approximate number of nodes of a GridLookup over the area.
double nodes_of_a_table(const plane::PlaneBox& area) {
  constexpr double step_m = 2000.0;
  constexpr double most_a_side = 1000.0;
  const double step = std::max(step_m, std::max(area.width_m(), area.height_m()) / most_a_side);
  return area.width_m() / step * (area.height_m() / step);
}

}  // namespace

PlanRequest for_any_way(const PlanRequest& request) {
  PlanRequest plain = request;
  plain.energy.objective = time_objective;
  plain.icebergs.encounter_weight = core::Seconds{0.0};
  plain.refine = false;
  plain.optimality_gap = false;
  plain.max_waypoints.reset();
  return plain;
}

TrialOutcome WayTrials::operator()(const PlanRequest& request) {
  const PlanRequest plain = for_any_way(request);
  const std::int64_t share = left_ / 4;
  std::int64_t of_share = share;
  TrialOutcome outcome = TrialOutcome::impossible;
  for (const cost::GridReach reach : cost::reaches(request)) {
    outcome = within(reach, plain, of_share);
    if (outcome != TrialOutcome::impossible || plain.method == Method::direct) break;
  }
  left_ -= share - of_share;
  return outcome;
}

std::int64_t WayTrials::work_of_a_chart(const PlanRequest& request, const cost::Layout& layout) const {
  double work = static_cast<double>(environment_.icebergs.size()) * static_cast<double>(work_of_a_berg);
  for (const cost::RouteGrid& grid : layout.grids) work += work_of_a_vertex * grid.vertex_count();
  double tables = 0.0;
  if (environment_.bathymetry) tables += 2.0;  // one for closed cells, one for dive depths
  if (environment_.ice) tables += 1.0 + static_cast<double>(environment_.further_ice.size());
  if (environment_.currents &&
      !shelf_.holds_currents(environment_, request, layout.projection, layout.area())) {
    work += work_of_a_value * static_cast<double>(environment_.currents->samples().u.size());
    tables += 1.0;
  }
  work += tables * work_of_a_node * nodes_of_a_table(layout.area());
  return std::llround(std::min(work, 1e15));
}

TrialOutcome WayTrials::within(cost::GridReach reach, const PlanRequest& request, std::int64_t& share) {
  const std::int64_t laid_out = work_of_a_chart(request, cost::lay_out(request, reach));
  if (laid_out >= share) return TrialOutcome::not_known;
  share -= laid_out;
  const Result<search::Chart> chart =
      search::draw_chart(environment_, request, reach, stop_, &shelf_, search::Moves::left_out);
  if (stop_.stop_requested()) return TrialOutcome::not_known;
  if (!chart) return TrialOutcome::impossible;

  std::optional<cost::Route> way = cost::fixed_route(chart->layout.points);
  if (request.method != Method::direct) {
    way = search_all(chart->sea, chart->layout.grids, request.sectors, share, stop_);
  }
  if (stop_.stop_requested() || (!way && share <= 0)) return TrialOutcome::not_known;
  if (!way) return TrialOutcome::impossible;
  const publish::Improved improved = publish::improve(chart->sea, *way, request, stop_);
  const auto plan = publish::publish(*chart, environment_, request, improved, {}, stop_);
  if (stop_.stop_requested()) return TrialOutcome::not_known;
  const auto& wanted = request.departures.arrive_by;
  const bool in_time = plan && (!wanted || plan->arrival <= *wanted);
  return in_time ? TrialOutcome::possible : TrialOutcome::impossible;
}

}  // namespace floeplan::planning::diagnosis
