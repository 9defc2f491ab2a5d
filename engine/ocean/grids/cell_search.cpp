#include "engine/ocean/grids/cell_search.hpp"

#include <cmath>
#include <numbers>

namespace floeplan::ocean {
namespace {

SpherePlace on_sphere(geo::LonLat place) {
  const double lon = place.lon_deg * std::numbers::pi / 180.0;
  const double lat = place.lat_deg * std::numbers::pi / 180.0;
  return {std::sin(lon), std::cos(lon), std::sin(lat), std::cos(lat)};
}

}  // namespace

Turn turn_between(const SpherePlace& from, const SpherePlace& to) {
  const double sine = from.cos_lon * to.sin_lon - from.sin_lon * to.cos_lon;
  const double cosine = from.cos_lon * to.cos_lon + from.sin_lon * to.sin_lon;
  const double along = cosine * (1.0 + from.sin_lat * to.sin_lat) + from.cos_lat * to.cos_lat;
  const double across = sine * (from.sin_lat + to.sin_lat);
  const double length = std::sqrt(along * along + across * across);
  return length > 0.0 ? Turn{along / length, across / length} : Turn{1.0, 0.0};
}

CellSearch::CellSearch(const Mesh& mesh, const HorizontalGrid& grid)
    : mesh_{mesh}, boxes_{grid, mesh}, columns_{grid.x().size()}, rows_{grid.y().size()} {
  points_.reserve(mesh.points.size());
  for (const geo::LonLat point : mesh.points) points_.push_back(on_sphere(point));
  if (std::holds_alternative<geo::GeographicFrame>(grid.frame())) {
    for (const double lon_deg : grid.x().nodes()) by_column_.push_back(on_sphere({lon_deg, 0.0}));
    for (const double lat_deg : grid.y().nodes()) by_row_.push_back(on_sphere({0.0, lat_deg}));
    return;
  }
  nodes_.reserve(grid.size());
  for (std::size_t iy = 0; iy < rows_; ++iy)
    for (std::size_t ix = 0; ix < columns_; ++ix) nodes_.push_back(on_sphere(grid.place(ix, iy)));
}

}  // namespace floeplan::ocean
