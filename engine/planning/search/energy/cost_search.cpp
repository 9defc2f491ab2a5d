#include "engine/planning/search/energy/cost_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/graph/label_search.hpp"
#include "engine/planning/search/energy/cost_voyage.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/route_search.hpp"
#include "engine/planning/search/voyage_search.hpp"

namespace floeplan::planning::search {
namespace {

constexpr std::size_t most_labels = 200'000;  // some seconds, and about 20 MB with their lists and the queue
/// On grids with more vertices than this a `CostOutlook` steers the search. Unsteered it would mostly reach
/// its limit on labels.
constexpr std::int64_t few_vertices = 2'500;
/// A steered search stops without a route after this number of labels per vertex. This happens mostly where
/// places close and reopen.
constexpr std::int64_t labels_a_vertex = 4;
constexpr std::int64_t fewest_labels = 50'000;
/// On grids with more vertices than this the outlook is not used: it would check the stop token too rarely,
/// and its memory limit would leave too few time slices.
constexpr std::int64_t many_vertices = 500'000;
/// The cost of a steered search may exceed the least cost by this share of the fastest route's cost. The error of
/// the outlook is far larger.
constexpr double near_enough = 2e-4;
/// How long after its last slice an outlook may be used. After that slice its currents stay constant.
constexpr core::Seconds beyond_outlook{3600.0};

using Way = std::vector<graph::Label<CostVoyage::State>>;

std::vector<geo::PlanePoint> points_of(const cost::RouteGrid& grid, const Way& way) {
  std::vector<geo::PlanePoint> points;
  for (const auto& label : way) points.push_back(grid.point(label.vertex));
  return points;
}

/// Adds the route over one grid, and returns whether it follows the grid's rim.
bool append(cost::DrivenRoute& route, const cost::Sea& sea, const cost::RouteGrid& grid, const Way& way) {
  const std::vector<geo::PlanePoint> points = points_of(grid, way);
  for (std::size_t i = 1; i < way.size(); ++i) {
    route.points.push_back(points[i]);
    route.fixed.push_back(i + 1 == way.size());
    route.drives.push_back(sea.drives()[way[i].choice]);
  }
  return touches_rim(points, grid);
}

/// When a search begins, and the time of the last possible surfacing before.
struct Beginning {
  core::Seconds depart;
  core::Seconds since_surfacing{};
};

/// The route of the earliest arrival, with the first propulsion of the model on every leg.
Result<CostWay> earliest_way(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                             const PlanRequest& request, core::Seconds depart, const std::stop_token& stop,
                             const std::function<void(double)>& report_fraction,
                             const RouteSearch* first = nullptr) {
  auto found = search_voyage(sea, grids, request, depart, stop, report_fraction, {.first = first});
  if (!found) return tl::unexpected(std::move(found.error()));
  const std::size_t legs = found->route.points.size() - 1;
  return CostWay{.route = {.points = std::move(found->route.points),
                           .fixed = std::move(found->route.fixed),
                           .drives = std::vector<vehicle::Drive>(legs, sea.drives().front())},
                 .statistics = found->statistics,
                 .touches_rim = found->touches_rim};
}

std::size_t labels_of_steered(const OpenGrid& open) {
  const auto most = static_cast<std::int64_t>(most_labels);
  return static_cast<std::size_t>(std::clamp(labels_a_vertex * open.vertices, fewest_labels, most));
}

/// Cost of the route without holds, with one propulsion. Infinite if the route is closed at these times, or
/// if it leaves less of the limit on the time without surfacing than the rest of the route needs.
double cost_along(const cost::Sea& sea, const OpenGrid& open, const std::vector<geo::PlanePoint>& path,
                  const Objective& objective, const Beginning& beginning, vehicle::Drive drive) {
  if (path.empty()) return INFINITY;
  const cost::DrivenRoute route{.points = path, .fixed = {}, .drives = std::vector(path.size() - 1, drive)};
  const auto times =
      cost::drive_along(sea, route, beginning.depart, beginning.since_surfacing, cost::Dives::over_map);
  if (!times) return INFINITY;
  if (sea.domain().overhead().bounds_surfacing() && times->since_surfacing + open.needed_after_goal() >
                                                        *sea.domain().overhead().longest_without_surfacing())
    return INFINITY;
  return times->cost(objective);
}

/// The least of `cost_along` over all kinds of propulsion.
double least_cost_along(const cost::Sea& sea, const OpenGrid& open, const std::vector<geo::PlanePoint>& path,
                        const Objective& objective, const Beginning& beginning) {
  double least = INFINITY;
  for (const vehicle::Drive drive : sea.drives())
    least = std::min(least, cost_along(sea, open, path, objective, beginning, drive));
  return least;
}

/// What a search for the least cost learns from the fastest route over a grid: an upper bound of the cost,
/// and the longest travel time that this cost allows.
class KnownLimit {
 public:
  KnownLimit(const cost::Sea& sea, const OpenGrid& open, const PlanRequest& request,
             const Beginning& beginning, CostGuide& guide, const std::stop_token& stop) {
    constexpr double rounding = 1e-9;  // relative, of sums of costs
    if (!guide.foresight().is_useful() && !sea.domain().closures().any_timed()) return;
    PlanRequest by_time = request;
    by_time.method = Method::astar;
    const core::Seconds depart = beginning.depart;
    fastest_ = search_route(
        sea, open, by_time, depart, stop, [](double) {}, core::Seconds{INFINITY}, beginning.since_surfacing,
        &guide.foresight());
    if (stop.stop_requested()) return;
    double cost = least_cost_along(sea, open, fastest_->path, request.objective(), beginning);
    bool has_way = !fastest_->path.empty();
    if (!has_way && sea.drives().size() > 1) {
      // The current or the limit on the time without surfacing may leave a route open to the faster
      // propulsion alone.
      const RouteSearch faster = search_route(
          sea.with({.drive = sea.drives().back()}), open, by_time, depart, stop, [](double) {},
          core::Seconds{INFINITY}, beginning.since_surfacing, &guide.foresight());
      cost = least_cost_along(sea, open, faster.path, request.objective(), beginning);
      has_way = !faster.path.empty();
    }
    // If the time without surfacing is limited, a search without a route may only have reached its limit of labels.
    is_hopeless_ = !has_way && !sea.domain().overhead().bounds_surfacing();
    if (is_hopeless_ || !guide.foresight().is_useful()) return;
    if (!std::isfinite(cost) || stop.stop_requested()) return;
    last_ = depart + core::Seconds{cost / CostVoyage::least_rate(sea, request.objective())};
    const auto end = sea.domain().currents() ? sea.domain().currents()->end() : std::nullopt;
    last_ = std::min(last_, end.value_or(last_));
    const std::size_t rungs = is_steered(open) ? 1 : ArrivalLadder::most_rungs;
    ladder_.emplace(guide.foresight(), open, depart, last_, stop, rungs);
    if (ladder_->has_hope()) limit_ = CostVoyage::Limit{(1.0 + rounding) * cost, &*ladder_};
  }
  KnownLimit(const KnownLimit&) = delete;
  KnownLimit& operator=(const KnownLimit&) = delete;

  /// The search for the fastest route by A*; empty where no lower bound is known.
  [[nodiscard]] const std::optional<RouteSearch>& fastest() const { return fastest_; }
  /// Whether no route exists with any propulsion: even the search for the fastest one found none.
  [[nodiscard]] bool is_hopeless() const { return is_hopeless_; }
  [[nodiscard]] const std::optional<CostVoyage::Limit>& limit() const { return limit_; }
  /// The latest possible arrival of a route that costs no more than the limit.
  [[nodiscard]] core::Seconds last() const { return last_; }
  [[nodiscard]] static bool is_steered(const OpenGrid& open) {
    return open.vertices > few_vertices && open.vertices <= many_vertices;
  }

 private:
  std::optional<ArrivalLadder> ladder_;
  std::optional<CostVoyage::Limit> limit_;
  core::Seconds last_{};
  std::optional<RouteSearch> fastest_;
  bool is_hopeless_{false};
};

}  // namespace

const CostOutlook& CostGuide::outlook(const Objective& objective, core::Seconds depart, core::Seconds last,
                                      const std::stop_token& stop) {
  if (!outlook_ || depart < from_ || last > until_ + beyond_outlook) {
    from_ = depart;
    until_ = last + ahead_;
    const ArrivalLadder use{foresight_, open_, from_, until_, stop, 1};
    outlook_.emplace(sea_, open_, objective, foresight_, use, from_, until_, stop);
  }
  return *outlook_;
}

Result<CostWay> search_least_cost(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                                  const PlanRequest& request, core::Seconds depart,
                                  const std::stop_token& stop,
                                  const std::function<void(double)>& report_fraction,
                                  std::vector<CostGuide>* guides) {
  // With one propulsion at constant power, energy is power times time, so the earliest arrival also costs
  // least.
  const bool is_by_time = request.objective().of_encounters == 0.0 && sea.energy_is_even();
  if (sea.drives().size() == 1 && is_by_time) {
    return earliest_way(sea, grids, request, depart, stop, report_fraction);
  }
  CostWay found;
  found.route.points.push_back(grids.front().grid.point(grids.front().grid.start));
  found.route.fixed.push_back(true);
  Beginning beginning{depart};
  std::optional<RouteSearch> first;  // the earliest route on the first grid
  const auto earliest_of_all = [&] {
    return earliest_way(sea, grids, request, depart, stop, report_fraction, first ? &*first : nullptr);
  };
  // The current or the limit on the time without surfacing may leave a route open to that propulsion alone.
  const auto earliest_on_faster_drive = [&](Result<CostWay> failed) {
    if (sea.drives().size() == 1 || stop.stop_requested()) return failed;
    auto earliest =
        earliest_way(sea.with({.drive = sea.drives().back()}), grids, request, depart, stop, report_fraction);
    return earliest ? std::move(earliest) : std::move(failed);
  };
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const OpenGrid& open = grids[i];
    std::optional<CostGuide> own_guide;
    CostGuide& guide = guides != nullptr ? (*guides)[i] : own_guide.emplace(sea, open);
    KnownLimit known{sea, open, request, beginning, guide, stop};
    if (i == 0 && request.method == Method::astar) first = known.fastest();
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    if (known.is_hopeless()) return earliest_of_all();
    const CostOutlook* outlook =
        known.limit() && KnownLimit::is_steered(open)
            ? &guide.outlook(request.objective(), beginning.depart, known.last(), stop)
            : nullptr;
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    CostVoyage voyage{sea, open, request.objective(), known.limit(), outlook};
    const double slack = outlook != nullptr ? near_enough * known.limit()->most_cost : 0.0;
    const std::size_t labels = outlook != nullptr ? labels_of_steered(open) : most_labels;
    const auto report = [&](std::int64_t expansions) {
      const double share = static_cast<double>(expansions) / static_cast<double>(labels);
      report_fraction((static_cast<double>(i) + std::min(share, 1.0)) / static_cast<double>(grids.size()));
    };
    const double now_s = beginning.depart.count();
    const CostVoyage::State state{.surfaced_s = now_s - beginning.since_surfacing.count()};
    const auto search = graph::find_best_labels(open.graph, open.grid.start, open.grid.goal, now_s, state,
                                                voyage, labels, stop, report, slack);
    if (search.stopped) return tl::unexpected(explain_cancelled(request));
    found.statistics.cut_short = found.statistics.cut_short || search.full;
    found.statistics.vertices += open.vertices;
    found.statistics.edges += open.edges;
    found.statistics.edge_evaluations += search.counters.edge_evaluations;
    found.statistics.expansions += search.counters.expansions;
    const auto way = search.goal ? graph::way_to(search, *search.goal) : Way{};
    if (way.empty()) {
      auto earliest = earliest_of_all();
      if (!earliest) earliest = earliest_on_faster_drive(std::move(earliest));
      if (!earliest) {
        earliest.error().search_cut_short |= search.full;
        return earliest;
      }
      earliest->statistics.cut_short |= search.full;
      earliest->route = cost::choose_drives(sea, earliest->route, request.objective(), depart, stop);
      return earliest;
    }
    beginning.depart = core::Seconds{way.back().arrival_s};
    beginning.since_surfacing = beginning.depart - core::Seconds{way.back().state.surfaced_s};
    if (append(found.route, sea, open.grid, way)) found.touches_rim = true;
  }
  return found;
}

}  // namespace floeplan::planning::search
