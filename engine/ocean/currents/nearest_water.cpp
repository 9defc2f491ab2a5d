#include "engine/ocean/currents/nearest_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace floeplan::ocean {
namespace {

bool is_water(const CurrentGrid::Samples& samples, std::size_t ix, std::size_t iy) {
  const std::size_t node = iy * samples.grid.x().size() + ix;
  const std::size_t levels = samples.depths_m ? samples.depths_m->size() : 1;
  const std::size_t last = (samples.times_s.size() - 1) * levels * samples.grid.size();
  return std::isfinite(samples.u[node]) || std::isfinite(samples.u[last + node]);
}

/// Whether the node or one of the eight round it has water.
bool has_water_beside(const CurrentGrid::Samples& samples, std::size_t ix, std::size_t iy) {
  const std::size_t east = std::min(ix + 1, samples.grid.x().size() - 1);
  const std::size_t north = std::min(iy + 1, samples.grid.y().size() - 1);
  for (std::size_t y = iy - std::min<std::size_t>(iy, 1); y <= north; ++y)
    for (std::size_t x = ix - std::min<std::size_t>(ix, 1); x <= east; ++x)
      if (is_water(samples, x, y)) return true;
  return false;
}

/// Grows with the distance between two places on a sphere: the squared length of the chord.
double chord(geo::LonLat a, geo::LonLat b) {
  constexpr double radians = std::numbers::pi / 180.0;
  const double north = std::sin((b.lat_deg - a.lat_deg) * radians / 2.0);
  const double east = std::sin((b.lon_deg - a.lon_deg) * radians / 2.0);
  return north * north + std::cos(a.lat_deg * radians) * std::cos(b.lat_deg * radians) * east * east;
}

}  // namespace

bool has_water_around(const CurrentGrid& currents, geo::LonLat place) {
  const CurrentGrid::Samples& samples = currents.samples();
  const auto cell = samples.grid.locate(place);
  if (!cell) return false;
  for (const std::size_t iy : {cell->y.lower, cell->y.upper})
    for (const std::size_t ix : {cell->x.lower, cell->x.upper})
      if (!has_water_beside(samples, ix, iy)) return false;
  return true;
}

std::optional<geo::LonLat> nearest_water(const CurrentGrid& currents, geo::LonLat place) {
  const CurrentGrid::Samples& samples = currents.samples();
  std::optional<geo::LonLat> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t iy = 0; iy < samples.grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < samples.grid.x().size(); ++ix) {
      if (!is_water(samples, ix, iy)) continue;
      const geo::LonLat node = samples.grid.place(ix, iy);
      const double away = chord(place, node);
      if (away >= least) continue;
      least = away;
      nearest = node;
    }
  }
  return nearest;
}

}  // namespace floeplan::ocean
