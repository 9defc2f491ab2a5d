#include "engine/planning/cost_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/graph/label_search.hpp"
#include "engine/planning/cost_voyage.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/openings.hpp"
#include "engine/planning/voyage_search.hpp"

namespace floeplan::planning {
namespace {

constexpr std::size_t most_labels = 1'000'000;  // about 100 MB with their lists and the queue

/// Adds the way over one grid; answers whether it keeps to the grid's rim.
bool append(DrivenRoute& route, const Sea& sea, const RouteGrid& grid,
            const std::vector<graph::Label<CostVoyage::State>>& way) {
  std::vector<geo::PlanePoint> points{grid.point(way.front().vertex)};
  for (std::size_t i = 1; i < way.size(); ++i) {
    points.push_back(grid.point(way[i].vertex));
    route.points.push_back(points.back());
    route.fixed.push_back(i + 1 == way.size());
    route.drives.push_back(sea.drives()[way[i].choice]);
  }
  return touches_rim(points, grid);
}

/// The way of the earliest arrival, all on the first drive.
Result<CostWay> earliest_way(const Sea& sea, const std::vector<OpenGrid>& grids, const PlanRequest& request,
                             core::Seconds depart, const std::stop_token& stop,
                             const std::function<void(double)>& report_fraction) {
  auto found = search_voyage(sea, grids, request, depart, stop, report_fraction);
  if (!found) return tl::unexpected(std::move(found.error()));
  const std::size_t legs = found->route.points.size() - 1;
  return CostWay{.route = {.points = std::move(found->route.points),
                           .fixed = std::move(found->route.fixed),
                           .drives = std::vector<vehicle::Drive>(legs, sea.drives().front())},
                 .statistics = found->statistics,
                 .cut_short = false,
                 .touches_rim = found->touches_rim};
}

}  // namespace

Result<CostWay> search_least_cost(const Sea& sea, const std::vector<OpenGrid>& grids,
                                  const PlanRequest& request, core::Seconds depart,
                                  const std::stop_token& stop,
                                  const std::function<void(double)>& report_fraction) {
  // One drive at one power: energy is power times time, and the earliest arrival costs least.
  const bool is_by_time = request.objective().of_encounters == 0.0 && sea.energy().is_even();
  if (sea.drives().size() == 1 && is_by_time) {
    return earliest_way(sea, grids, request, depart, stop, report_fraction);
  }
  CostWay found;
  found.route.points.push_back(grids.front().grid.point(grids.front().grid.start));
  found.route.fixed.push_back(true);
  double now_s = depart.count();
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const OpenGrid& open = grids[i];
    std::optional<Openings> openings;
    if (sea.has_timed_closures()) openings.emplace(sea, open, core::Seconds{INFINITY}, stop);
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
    CostVoyage voyage{sea, open.grid, request.objective(), openings ? &*openings : nullptr};
    const auto report = [&](std::int64_t expansions) {
      const double share = static_cast<double>(expansions) / static_cast<double>(most_labels);
      report_fraction((static_cast<double>(i) + std::min(share, 1.0)) / static_cast<double>(grids.size()));
    };
    const auto search = graph::find_best_labels(open.graph, open.grid.start, open.grid.goal, now_s,
                                                CostVoyage::State{}, voyage, most_labels, stop, report);
    if (search.stopped) return tl::unexpected(explain_cancelled(request));
    if (!search.goal) {
      auto earliest = earliest_way(sea, grids, request, depart, stop, report_fraction);
      if (earliest) earliest->cut_short = search.full;
      return earliest;
    }
    const auto way = graph::way_to(search, *search.goal);
    now_s = way.back().arrival_s;
    if (append(found.route, sea, open.grid, way)) found.touches_rim = true;
    found.statistics.vertices += open.vertices;
    found.statistics.edges += open.edges;
    found.statistics.edge_evaluations += search.counters.edge_evaluations;
    found.statistics.expansions += search.counters.expansions;
  }
  return found;
}

}  // namespace floeplan::planning
