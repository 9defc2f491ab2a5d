#include "engine/planning/find_isochrones.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/geo/antimeridian.hpp"
#include "engine/graph/contour.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/isochrone_search.hpp"

namespace floeplan::planning {
namespace {

using graph::Vertex;
using Direction = IsochroneRequest::Direction;

constexpr double most_vertices = 1e7;          // some minutes and half a gigabyte
constexpr std::size_t most_icebergs = 20'000;  // some seconds of forecasts
constexpr double map_cells_per_step = 3.0;     // cells of the safety map per grid step
constexpr int halvings = 8;                    // of a closed line between two vertices, to find its open part
// Edges of a k-sector grid span at most k vertices. With this margin the vertices next to the outline have
// arrivals.
constexpr double steps_beyond = 3.0;
/// Test in the Kuroshio and the Agulhas Current: with 3 sectors the area was 0.79 to 1.0 of that of a finer
/// search, with 5 sectors 0.96 to 1.03, in three times the time.
constexpr int sectors_in_strong_currents = 5;
constexpr int usual_sectors = 3;

plane::PlaneBox box_around(geo::PlanePoint centre, double radius_m) {
  return plane::PlaneBox{centre, centre}.grown(radius_m);
}

/// A square grid around the place, which is both start and goal.
cost::RouteGrid grid_around(geo::PlanePoint centre, core::Metres radius, core::Metres step) {
  const int steps = static_cast<int>(std::ceil(radius / step));
  cost::RouteGrid grid;
  grid.origin = {centre.x_m - steps * step.value, centre.y_m - steps * step.value};
  grid.along = {step.value, 0.0};
  grid.across = {0.0, step.value};
  grid.nx = 2 * steps + 1;
  grid.ny = grid.nx;
  grid.start = static_cast<Vertex>(steps * grid.nx + steps);
  grid.goal = grid.start;
  return grid;
}

/// Radius of the grid: the distance that the strongest current can carry the vehicle, and some steps more.
core::Metres grid_radius(const cost::Sea& sea, const IsochroneRequest& request) {
  const core::MetresPerSecond current =
      sea.domain().currents() ? sea.domain().currents()->strongest() : core::MetresPerSecond{0.0};
  const double fastest_m_s = request.through_water().value + current.value;
  const double farthest_m = 1.01 * fastest_m_s * request.reach().count() + 2.0 * request.step().value;
  return std::min(request.data_radius(), core::Metres{farthest_m});
}

/// Makes the areas reached within each span from the result of a search.
class ReachedAreas {
 public:
  /// All references are borrowed and must outlive this.
  ReachedAreas(const cost::Sea& sea, const search::OpenGrid& open, Direction direction,
               const search::Reached& reached)
      : sea_{sea}, open_{open}, direction_{direction}, reached_{reached} {}

  /// Polygons around the vertices reached until `level` on the search's clock.
  std::vector<graph::GridPolygon> until(core::Seconds level) const {
    std::vector<std::uint8_t> inside(open_.graph.size());
    for (Vertex v = 0; v < inside.size(); ++v) inside[v] = reached_.earliest_s(v) <= level.count() ? 1 : 0;
    return graph::contour(open_.grid.nx, open_.grid.ny, inside, [&](Vertex in, Vertex out) {
      const double in_s = reached_.earliest_s(in);
      const double out_s = reached_.earliest_s(out);
      if (std::isfinite(out_s) && !closed_between(in, out)) return (level.count() - in_s) / (out_s - in_s);
      return share_travelled(in, out, level);
    });
  }

 private:
  bool closed_between(Vertex in, Vertex out) const {
    return sea_.domain().closures().closed_between(open_.grid.point(in), open_.grid.point(out)).has_value();
  }

  /// How far the vehicle comes by the time `level` on the straight line from `in` to `out`, as a share of that
  /// line. It does not reach `out` by then.
  double share_travelled(Vertex in, Vertex out, core::Seconds level) const {
    const geo::PlanePoint from = open_.grid.point(in);
    const geo::PlanePoint to = open_.grid.point(out);
    const auto reaches = [&](double share) {
      const geo::PlanePoint there{from.x_m + share * (to.x_m - from.x_m),
                                  from.y_m + share * (to.y_m - from.y_m)};
      return std::ranges::any_of(reached_.at(in), [&](const search::Presence& here) {
        if (here.when > level) return false;
        const auto end = search::go_on(sea_, direction_, from, there, here, level);
        return end && end->when <= level;
      });
    };
    double reached = 0.0;
    double not_reached = 1.0;
    for (int i = 0; i < halvings; ++i) {
      const double share = 0.5 * (reached + not_reached);
      (reaches(share) ? reached : not_reached) = share;
    }
    return reached;
  }

  const cost::Sea& sea_;
  const search::OpenGrid& open_;
  Direction direction_;
  const search::Reached& reached_;
};

double area_m2(const graph::GridRing& ring, double cell_m2) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const graph::GridPlace& a = ring[i];
    const graph::GridPlace& b = ring[(i + 1) % ring.size()];
    doubled += a.column * b.row - b.column * a.row;
  }
  return 0.5 * doubled * cell_m2;
}

geo::Ring to_ring(const graph::GridRing& ring, const cost::RouteGrid& grid,
                  const geo::LocalProjection& projection) {
  geo::Ring result;
  for (const graph::GridPlace place : ring) {
    result.push_back(projection.to_lon_lat(
        {grid.origin.x_m + place.column * grid.along.x_m + place.row * grid.across.x_m,
         grid.origin.y_m + place.column * grid.along.y_m + place.row * grid.across.y_m}));
  }
  return result;
}

Isochrone to_area(const std::vector<graph::GridPolygon>& polygons, const cost::RouteGrid& grid,
                  const cost::Sea& sea) {
  const double cell_m2 = grid.along.x_m * grid.across.y_m;
  Isochrone area;
  for (const graph::GridPolygon& polygon : polygons) {
    geo::Polygon on_globe{.outer = to_ring(polygon.outer, grid, sea.domain().projection()), .holes = {}};
    area.area_m2 += area_m2(polygon.outer, cell_m2);
    for (const graph::GridRing& hole : polygon.holes) {
      on_globe.holes.push_back(to_ring(hole, grid, sea.domain().projection()));
      area.area_m2 += area_m2(hole, cell_m2);
    }
    std::ranges::move(geo::split_at_antimeridian(on_globe), std::back_inserter(area.polygons));
  }
  return area;
}

/// Why the vehicle cannot be at the place at its departure or arrival; empty if it can.
std::optional<motion::EdgeClosed> closed_place(const cost::Sea& sea, geo::PlanePoint place,
                                               const IsochroneRequest& request) {
  if (const auto closed = sea.domain().safety().closed_at(request.place)) return closed;
  const core::Seconds then = request.time - request.begin();
  for (const TimeSpan& span : sea.domain().closures().closed_times(place)) {
    if (span.from <= then && then <= span.until) return motion::EdgeClosed::obstacle;
  }
  return std::nullopt;
}

/// Whether the search reached the rim of its grid by `level`, so that the area may extend beyond.
bool touches_rim(const search::Reached& reached, const cost::RouteGrid& grid, core::Seconds level) {
  const auto is_in = [&](int column, int row) {
    return reached.earliest_s(static_cast<Vertex>(row * grid.nx + column)) <= level.count();
  };
  for (int i = 0; i < grid.nx; ++i) {
    if (is_in(i, 0) || is_in(i, grid.ny - 1) || is_in(0, i) || is_in(grid.nx - 1, i)) return true;
  }
  return false;
}

bool has_strong_currents(const cost::Sea& sea) {
  return sea.domain().currents() && sea.domain().currents()->strongest() >= sea.through_water();
}

/// The message if the battery does not last for the longest span.
std::optional<messages::Message> of_battery(const cost::Sea& sea, const IsochroneRequest& request) {
  const core::Joules usable = request.vehicle.energy.usable();
  const core::Watts power = sea.energy().least_power(sea.drives().front());
  if (power * request.reach() <= usable) return std::nullopt;
  return messages::plan_message<"areas-beyond-battery">(usable.value / 1e6,
                                                        std::max(0.0, usable.value / power.value) / 3600.0);
}

}  // namespace

Result<Isochrones> find_isochrones(const ocean::Environment& environment, const IsochroneRequest& request,
                                   const std::stop_token& stop, const core::ProgressCallback& report) {
  if (!request.violations().empty()) throw std::invalid_argument{request.violations().front().rule};
  const core::ProgressCallback progress = core::never_falling(report);
  progress("environment", 0.0);
  const PlanRequest voyage = voyage_of(request);
  const double side = 2.0 * request.data_radius() / request.step() + 1.0;
  if (side * side > most_vertices) return tl::unexpected(search::explain_too_large(side * side, voyage));
  if (environment.icebergs.size() > most_icebergs) {
    return tl::unexpected(search::explain_too_many_icebergs(environment.icebergs.size(), voyage));
  }

  const geo::LocalProjection projection{request.place};
  const geo::PlanePoint place = projection.to_plane(request.place);
  const core::Metres cell{request.step().value / map_cells_per_step};
  const plane::PlaneBox area = box_around(place, request.data_radius().value + 2.0 * request.step().value);
  cost::Sea sea{environment, voyage, projection, area, cell, stop};
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(voyage));
  if (const auto closed = closed_place(sea, place, request)) {
    const search::Stop kind = request.direction == Direction::from ? search::Stop::start : search::Stop::goal;
    return tl::unexpected(search::explain_place(*closed, kind, request.place, sea, environment, voyage));
  }
  sea.domain().safety().open_around(place);

  const bool is_strong = has_strong_currents(sea);
  const int sectors = request.sectors.value_or(is_strong ? sectors_in_strong_currents : usual_sectors);
  const search::OpenGrid open = search::open_grid(
      sea.domain(), grid_around(place, grid_radius(sea, request), request.step()), sectors, stop);
  const core::Seconds begin = request.direction == Direction::from ? core::Seconds{0.0} : -request.reach();
  const core::Seconds beyond = steps_beyond * (request.step() / sea.through_water());
  const search::Reached reached = search::find_reached(
      sea, open, request.direction, begin, begin + request.reach() + beyond, stop,
      [&](std::int64_t expansions) {
        const auto vertices = static_cast<double>(open.vertices);
        progress("search", 0.1 + 0.8 * std::min(1.0, static_cast<double>(expansions) / vertices));
      });
  if (reached.stopped || stop.stop_requested()) return tl::unexpected(search::explain_cancelled(voyage));

  Isochrones reach;
  reach.search.vertices = open.vertices;
  reach.search.edges = open.edges;
  reach.search.edge_evaluations = reached.edge_evaluations;
  reach.search.expansions = reached.expansions;
  reach.datasets = environment.datasets;
  reach.messages = environment.messages;
  std::vector<core::Seconds> spans = request.spans;
  std::ranges::sort(spans);
  spans.erase(std::ranges::unique(spans).begin(), spans.end());
  const ReachedAreas areas{sea, open, request.direction, reached};
  for (const core::Seconds span : spans) {
    if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(voyage));
    Isochrone one = to_area(areas.until(begin + span), open.grid, sea);
    one.span = span;
    one.time = request.direction == Direction::from ? request.time + span : request.time - span;
    reach.areas.push_back(std::move(one));
  }
  if (is_strong) {
    reach.messages.push_back(request.direction == Direction::to
                                 ? messages::plan_message<"areas-to-a-place-in-strong-currents">()
                                 : messages::plan_message<"areas-in-strong-currents">());
  }
  if (auto message = of_battery(sea, request)) reach.messages.push_back(std::move(*message));
  if (reached.full) reach.messages.push_back(messages::plan_message<"areas-cut-short">());
  if (touches_rim(reached, open.grid, begin + spans.back()))
    reach.messages.push_back(messages::plan_message<"areas-cut-at-the-data">());
  return reach;
}

}  // namespace floeplan::planning
