#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/planning/plane/plane_box.hpp"
#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "engine/simulation/flight/flight_path.hpp"

namespace floeplan::simulation {
namespace {

constexpr int most_places = 24;  // on each side of the stored grid
constexpr int most_times = 48;
constexpr double least_spacing_m = 500.0;
constexpr double around_route_m = 5000.0;  // far more than any detour
constexpr core::Seconds least_time_step{1800.0};
/// How far off its axis a beam still reports an echo, as a share of its height. Half of it; and a quarter
/// more, where the next row hears the echo better, but by less than 6 dB (simulation::Sonar).
constexpr double heard_beside_axis = 0.75;

/// Four depths of the saw-tooth, including both turns.
std::vector<core::Metres> depths_of(const YoOrders& yo) {
  const double top_m = yo.climb.depth.value;
  const double bottom_m = std::max(yo.dive.depth.value, top_m + 3.0);
  std::vector<core::Metres> depths;
  depths.reserve(4);
  for (int i = 0; i < 4; ++i) depths.push_back({top_m + (bottom_m - top_m) * i / 3.0});
  return depths;
}

avoidance::CarriedForecast::Grid grid_over(const planning::plane::PlaneBox& area) {
  avoidance::CarriedForecast::Grid grid;
  const double longer_m = std::max(area.width_m(), area.height_m());
  const double spacing_m = std::max(least_spacing_m, longer_m / (most_places - 1));
  grid.origin = area.low;
  grid.spacing = {spacing_m};
  grid.columns = std::min(most_places, static_cast<int>(std::ceil(area.width_m() / spacing_m)) + 1);
  grid.rows = std::min(most_places, static_cast<int>(std::ceil(area.height_m() / spacing_m)) + 1);
  return grid;
}

}  // namespace

SystemOnBoard system_for(const World& world, const MissionOrders& orders, geo::LonLat start,
                         core::UtcTime departure, core::Seconds duration) {
  const geo::PlanePoint from = world.projection().to_plane(start);
  planning::plane::PlaneBox area{from, from};
  std::vector<geo::PlanePoint> waypoints;
  for (const RouteStop& stop : flight_path(world, orders, start).stops) {
    waypoints.push_back({stop.place.east, stop.place.north});
    area.include(waypoints.back());
  }
  avoidance::CarriedForecast::Grid grid = grid_over(area.grown(around_route_m));
  grid.depths = depths_of(orders.yo);
  const core::Seconds step = std::max(least_time_step, duration / (most_times - 1));
  for (int i = 0; i < most_times && (i == 0 || step * (i - 1) < duration); ++i)
    grid.times.push_back(departure + step * i);
  for (const core::UtcTime time : grid.times) {
    for (const core::Metres depth : grid.depths) {
      for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
          const Vector place{grid.origin.x_m + column * grid.spacing.value,
                             grid.origin.y_m + row * grid.spacing.value, depth.value};
          const Vector current = world.true_current().forecast_at(place, time).value_or(Vector{});
          grid.values.push_back({{current.east}, {current.north}});
        }
      }
    }
  }
  return {std::move(waypoints), avoidance::CarriedForecast{std::move(grid)}, {}};
}

avoidance::AvoidanceSettings avoidance_for(const vehicle::GliderProfile& vehicle, const MissionOrders& orders,
                                           const SonarSettings& sonar) {
  avoidance::AvoidanceSettings settings;
  settings.sonar.reach = {sonar.range_m};
  settings.sonar.half_height = {0.5 * ((sonar.rows - 1) * sonar.row_step_rad + sonar.beam.height_rad)};
  settings.sonar.tilt = {sonar.tilt_rad};
  settings.sonar.beam_half_height = {heard_beside_axis * sonar.beam.height_rad};
  settings.sonar.edge = {std::max(0.0, 0.5 * (sonar.rows - 1.5)) * sonar.row_step_rad};
  settings.sonar.edge_half_height = {main_lobe_half_width_rad(sonar.beam.height_rad)};
  settings.through_water = vehicle.speed_through_water;
  settings.shallowest = orders.yo.climb.depth;
  settings.deepest = orders.yo.dive.depth;
  settings.vertical_margin = vehicle.altimeter_margin;
  settings.least_water = vehicle.least_water();
  if (!orders.lists.empty())
    settings.waypoint_radius = std::ranges::min(orders.lists, {}, &GotoOrders::radius).radius;
  return settings;
}

ForesightSettings foresight_of(const vehicle::GliderProfile& vehicle, const MissionOrders& orders,
                               const SonarSettings& sonar) {
  ForesightSettings settings;
  settings.sonar_range = {sonar.range_m};
  settings.through_water = vehicle.speed_through_water;
  settings.shallowest = orders.yo.climb.depth;
  settings.deepest = orders.yo.dive.depth;
  return settings;
}

}  // namespace floeplan::simulation
