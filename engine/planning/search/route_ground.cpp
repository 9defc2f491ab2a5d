#include "engine/planning/search/route_ground.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/cost/sea_layout.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::search {
namespace {

constexpr double origin_step_deg =
    0.25;  // the plane may have its centre a quarter of a degree away without loss of accuracy
// Least number of lattice steps on the area's longer side. With few steps a slightly moved route rarely
// leaves its area.
constexpr double area_steps = 5.0;
// Cell sizes are rounded to this many values per doubling: the map is at most a sixth finer than requested.
constexpr double cells_per_octave = 4.0;

geo::LonLat on_lattice(geo::LonLat place) {
  const auto nearest = [](double deg) { return origin_step_deg * std::round(deg / origin_step_deg); };
  return {geo::wrap_longitude(nearest(place.lon_deg)), nearest(place.lat_deg)};
}

/// The smallest box on the lattice around this one; the step of the lattice is a power of two.
plane::PlaneBox on_lattice(const plane::PlaneBox& box) {
  const double longer_m = std::max(box.width_m(), box.height_m());
  const double step_m = std::exp2(std::floor(std::log2(longer_m / area_steps)));
  const auto down = [step_m](double m) { return step_m * std::floor(m / step_m); };
  const auto up = [step_m](double m) { return step_m * std::ceil(m / step_m); };
  return {{down(box.low.x_m), down(box.low.y_m)}, {up(box.high.x_m), up(box.high.y_m)}};
}

core::Metres on_lattice(core::Metres cell) {
  return core::Metres{std::exp2(std::floor(cells_per_octave * std::log2(cell.value)) / cells_per_octave)};
}

}  // namespace

cost::GridReach reach_beside(const PlanRequest& request) {
  constexpr cost::GridReach beside_route{0.2, 0.1};
  return request.under_ice.escape_plan ? cost::first_reach : beside_route;
}

PlanRequest request_along(const std::vector<geo::LonLat>& route, const PlanRequest& request) {
  if (route.size() < 2) throw std::invalid_argument{"a route has at least two places"};
  PlanRequest on_route = request;
  on_route.from = route.front();
  on_route.to = route.back();
  on_route.via.assign(route.begin() + 1, route.end() - 1);
  on_route.method = Method::direct;
  on_route.max_waypoints.reset();
  if (!on_route.spacing_along) {
    // The safety map's cell follows from the length of the whole route, not from its short legs.
    core::Metres length{0.0};
    for (std::size_t i = 1; i < route.size(); ++i)
      length = length + geo::geodesic_between(route[i - 1], route[i]).length;
    on_route.spacing_along = cost::spacing_for(request, length).along;
  }
  throw_if_invalid(on_route);
  return on_route;
}

RouteSite site_of(const PlanRequest& on_route) {
  const geo::LonLat origin = on_lattice(cost::middle_of_stops(on_route));
  const cost::Layout layout = cost::lay_out(on_route, reach_beside(on_route), geo::LocalProjection{origin});
  const core::Metres cell = on_lattice(layout.map_cell());
  return {.origin = origin,
          .area = on_lattice(layout.bounds().grown(2.0 * cell.value)),
          .cell = cell,
          .drift = cost::drift_for_the_way(on_route),
          .ends = on_route.icebergs.pass_under ? std::vector{on_route.from, on_route.to}
                                               : std::vector<geo::LonLat>{}};
}

RouteGround::RouteGround(ocean::Environment environment, const PlanRequest& on_route, RouteSite site,
                         const std::stop_token& stop, cost::SeaShelf* shelf)
    : environment_{std::move(environment)},
      site_{std::move(site)},
      sea_{environment_, on_route, geo::LocalProjection{site_.origin}, site_.area, site_.cell, stop, shelf} {
  environment_.currents.reset();
  environment_.members.clear();
  environment_.drift_currents.reset();
  environment_.drift_members.clear();
  environment_.wind.reset();
}

std::size_t RouteGround::bytes() const {
  std::size_t bytes = sea_.bytes();
  if (environment_.bathymetry) bytes += environment_.bathymetry->bytes();
  if (environment_.ice) bytes += environment_.ice->bytes();
  for (const auto& ice : environment_.further_ice) bytes += ice->bytes();
  for (const geo::Polygon& polygon : environment_.land) bytes += polygon.bytes();
  return bytes + environment_.icebergs.size() * sizeof(ocean::Iceberg);
}

Result<std::shared_ptr<const RouteGround>> lay_out_ground(ocean::Environment environment,
                                                          const PlanRequest& on_route, const RouteSite& site,
                                                          const std::stop_token& stop,
                                                          cost::SeaShelf* shelf) {
  if (auto too_much = too_much_to_lay_out(environment, on_route)) return tl::unexpected(std::move(*too_much));
  auto ground = std::make_shared<const RouteGround>(std::move(environment), on_route, site, stop, shelf);
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(on_route));
  return ground;
}

}  // namespace floeplan::planning::search
