#include "engine/planning/voyage_search.hpp"

#include <algorithm>
#include <cmath>

#include "engine/planning/explanation.hpp"
#include "engine/planning/late_openings.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/route_search.hpp"

namespace floeplan::planning {
namespace {

void add(SearchStatistics& sum, const SearchStatistics& part) {
  sum.vertices += part.vertices;
  sum.edges += part.edges;
  sum.edge_evaluations += part.edge_evaluations;
  sum.expansions += part.expansions;
  sum.reinsertions += part.reinsertions;
  sum.fifo_violations += part.fifo_violations;
  sum.possible_gain = part.possible_gain;
  sum.cut_short = sum.cut_short || part.cut_short;
  sum.worst_fifo_violation = worse_of(sum.worst_fifo_violation, part.worst_fifo_violation);
}

/// The part of a way between two stops: `part` counts from 0.
std::vector<geo::PlanePoint> part_of(const Route& route, std::size_t part) {
  std::vector<geo::PlanePoint> points;
  std::size_t stops = 0;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    if (route.fixed[i]) ++stops;
    if (stops == part + 1 || (stops == part + 2 && route.fixed[i])) points.push_back(route.points[i]);
  }
  return points;
}

/// An arrival at the end of a part that is certainly possible, with room for the tolerance of its times;
/// infinite when the other departure's way is closed now.
core::Seconds arrival_by(const Sea& sea, const FoundWay& other, std::size_t part, core::Seconds depart) {
  constexpr double slack = 1e-3;
  const auto arrivals = arrivals_along(sea, part_of(other.route, part), depart);
  if (!arrivals) return core::Seconds{INFINITY};
  return arrivals->back() + slack * (arrivals->back() - depart);
}

}  // namespace

bool touches_rim(const std::vector<geo::PlanePoint>& path, const RouteGrid& grid) {
  const double along2 = grid.along.x_m * grid.along.x_m + grid.along.y_m * grid.along.y_m;
  const double across2 = grid.across.x_m * grid.across.x_m + grid.across.y_m * grid.across.y_m;
  return std::ranges::any_of(path, [&](geo::PlanePoint p) {
    const double dx = p.x_m - grid.origin.x_m;
    const double dy = p.y_m - grid.origin.y_m;
    const double column = (dx * grid.along.x_m + dy * grid.along.y_m) / along2;
    const double row = (dx * grid.across.x_m + dy * grid.across.y_m) / across2;
    return column < 0.5 || column > grid.nx - 1.5 || row < 0.5 || row > grid.ny - 1.5;
  });
}

Result<FoundWay> search_voyage(const Sea& sea, const std::vector<OpenGrid>& grids, const PlanRequest& request,
                               core::Seconds depart, const std::stop_token& stop,
                               const std::function<void(double)>& report_fraction,
                               const OtherDepartures& others) {
  FoundWay found;
  core::Seconds since_surfacing{0.0};
  found.route.points.push_back(grids.front().grid.point(grids.front().grid.start));
  found.route.fixed.push_back(true);
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const auto search_by = [&](core::Seconds latest) {
      const auto report = [&](double fraction) {
        report_fraction((static_cast<double>(i) + fraction) / static_cast<double>(grids.size()));
      };
      return search_route(sea, grids[i], request, depart, stop, report, latest, since_surfacing,
                          others.foresights != nullptr ? &(*others.foresights)[i] : nullptr);
    };
    const bool bounded = others.way != nullptr && !sea.has_timed_closures();
    const core::Seconds latest = bounded ? arrival_by(sea, *others.way, i, depart) : core::Seconds{INFINITY};
    RouteSearch search = search_by(latest);
    // Where FIFO does not hold the search may miss the way that gave the bound.
    if (search.path.empty() && std::isfinite(latest.count()) && !search.cancelled) {
      search = search_by(core::Seconds{INFINITY});
    }
    add(found.statistics, search.statistics);
    if (search.cancelled) return tl::unexpected(explain_cancelled(request));
    if (search.path.empty() && search.opens_later) {
      const Stop kind = i + 1 == grids.size() ? Stop::goal : Stop::via;
      return tl::unexpected(
          explain_circling(*search.opens_later, kind, grids[i].grid.point(grids[i].grid.goal), sea, request));
    }
    if (search.path.empty()) return tl::unexpected(explain_search(search, sea, request));

    const auto arrivals = arrivals_along(sea, search.path, depart, since_surfacing);
    if (!arrivals) return tl::unexpected(explain_route(arrivals.error(), sea, request));
    depart = arrivals->back();
    since_surfacing = search.since_surfacing;
    found.touches_rim = found.touches_rim || touches_rim(search.path, grids[i].grid);
    for (std::size_t p = 1; p < search.path.size(); ++p) {
      found.route.points.push_back(search.path[p]);
      found.route.fixed.push_back(p + 1 == search.path.size());
    }
  }
  found.arrival = depart;
  // What is gained to one stop may be lost, or doubled, to the next.
  if (grids.size() > 1) found.statistics.possible_gain.reset();
  return found;
}

}  // namespace floeplan::planning
