#include "engine/simulation/world/true_current.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace floeplan::simulation {
namespace {

/// For a place without water these cells around it are tried, ring by ring outwards. Plans extend a model's
/// currents as far beyond its land mask, which is coarser than the coast (planning::PlaneCurrents).
constexpr std::array<std::array<Vector, 4>, 4> rings{
    {{{{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}},
     {{{1.0, 1.0, 0.0}, {-1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, -1.0, 0.0}}},
     {{{2.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, -2.0, 0.0}}},
     {{{2.0, 2.0, 0.0}, {-2.0, 2.0, 0.0}, {2.0, -2.0, 0.0}, {-2.0, -2.0, 0.0}}}}};

/// The current at `depth_m`, linear between levels. Below the deepest level with water, the current of this
/// level.
std::optional<geo::VelocityEn> down_to(const ocean::CurrentGrid& grid, geo::LonLat place, double depth_m,
                                       core::UtcTime time) {
  const auto& levels = grid.samples().depths_m;
  if (!levels) return grid.at(place, {depth_m}, time);
  const double within_m = std::clamp(depth_m, levels->front(), levels->back());
  if (const auto found = grid.at(place, {within_m}, time)) return found;
  const auto& nodes = levels->nodes();
  for (auto level = std::ranges::lower_bound(nodes, within_m); level != nodes.begin();) {
    if (const auto found = grid.at(place, {*--level}, time)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vector> TrueCurrent::forecast_at(Vector place, core::UtcTime time) const {
  if (!forecast_.grid) return uniform_;
  const ocean::CurrentGrid& grid = *forecast_.grid;
  const core::UtcTime when = forecast_.steady ? core::from_unix_seconds(grid.times_s().front()) : time;
  const auto in_plane = [&](Vector at) -> std::optional<Vector> {
    const geo::LonLat lon_lat = projection_->to_lon_lat({at.east, at.north});
    const auto water = down_to(grid, lon_lat, at.down, when);
    if (!water) return std::nullopt;
    const geo::PlaneVelocity velocity = projection_->to_plane(*water, lon_lat);
    return Vector{velocity.x_m_s, velocity.y_m_s, 0.0};
  };
  if (const auto here = in_plane(place)) return here;

  const double cell_m = grid.samples().grid.spacing().value;
  for (const auto& ring : rings) {
    Vector sum{};
    int found = 0;
    for (const Vector& cells : ring) {
      if (const auto water = in_plane(place + cell_m * cells)) {
        sum = sum + *water;
        ++found;
      }
    }
    if (found > 0) return (1.0 / found) * sum;
  }
  return std::nullopt;
}

std::optional<Vector> TrueCurrent::at(Vector place, core::UtcTime time) const {
  const auto forecast = forecast_at(place, time);
  if (!forecast) return std::nullopt;
  return *forecast + error_.at(place, time);
}

}  // namespace floeplan::simulation
