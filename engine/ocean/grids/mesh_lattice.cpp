#include "engine/ocean/grids/mesh_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floeplan::ocean {
namespace {

constexpr double max_lattice_nodes = 4e6;  // weights take 48 bytes per node: 200 MB
constexpr double half = 0.5;               // of the mesh's spacing; interpolating twice then loses little
constexpr double max_fine_nodes = 1e6;     // above this a finer grid is not worth its size
constexpr double nodes_per_point = 4.0;    // for half the spacing, on a mesh of squares
constexpr double share_of_fine_sides = 0.25;
constexpr double metres_per_lat_degree = 111'195.0;  // on a sphere with the Earth's mean radius
constexpr double polar_from_lat_deg = 78.0;   // a degree of longitude is here a fifth of one of latitude
constexpr double polar_above_lat_deg = 45.0;  // the whole mesh must lie poleward; else scales differ too much

std::vector<geo::LonLat> used_points(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  for (const Mesh::Cell& cell : mesh.cells)
    for (const std::uint32_t corner : cell) used[corner] = true;
  std::vector<geo::LonLat> points;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.push_back(mesh.points[i]);
  return points;
}

/// Nodes from `from` to at least `to`, `step` apart.
std::vector<double> nodes_between(double from, double to, double step) {
  const auto count = static_cast<std::size_t>(std::ceil((to - from) / step - 1e-9)) + 1;
  std::vector<double> nodes(count);
  for (std::size_t i = 0; i < count; ++i) nodes[i] = from + step * static_cast<double>(i);
  return nodes;
}

/// Half the spacing of the mesh; more if that would take too many nodes.
double affordable_step(double spacing, double area) {
  return std::max({half * spacing, std::min(spacing, std::sqrt(area / max_fine_nodes)),
                   std::sqrt(area / max_lattice_nodes)});
}

/// Rounded down to two digits, so that coordinates of nodes have few digits.
double rounded(double step) {
  const double digit = std::pow(10.0, std::floor(std::log10(step)) - 1.0);
  return std::max(std::floor(step / digit + 1e-9), 1.0) * digit;
}

double start_before(double value, double step) { return std::floor(value / step + 1e-9) * step; }

HorizontalGrid polar_grid(const std::vector<geo::LonLat>& points, double spacing_m) {
  const geo::BoundingBox box = geo::bounding_box(points);
  const bool north = box.north_deg > 0.0;
  const geo::PolarStereographicFrame frame{
      .north = north,
      .lat_ts_deg = north ? 70.0 : -70.0,
      .lon_0_deg = std::round(geo::wrap_longitude(box.west_deg + 0.5 * geo::width_deg(box)))};
  const geo::FrameProjection projection{frame};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double least_x = infinite;
  double most_x = -infinite;
  double least_y = infinite;
  double most_y = -infinite;
  for (const geo::LonLat place : points) {
    const geo::GridPoint at = projection.to_grid(place);
    least_x = std::min(least_x, at.x);
    most_x = std::max(most_x, at.x);
    least_y = std::min(least_y, at.y);
    most_y = std::max(most_y, at.y);
  }
  const double step = rounded(affordable_step(spacing_m, (most_x - least_x) * (most_y - least_y)));
  return {frame, Axis{nodes_between(start_before(least_x, step), most_x, step)},
          Axis{nodes_between(start_before(least_y, step), most_y, step)}};
}

/// Whether cells cross the gap of longitudes without points: then the mesh goes all the way round.
bool closes_round(const Mesh& mesh, const geo::BoundingBox& box) {
  const auto east_of_west = [&](std::uint32_t corner) {
    const double turn = std::fmod(mesh.points[corner].lon_deg - box.west_deg, 360.0);
    return turn < 0.0 ? turn + 360.0 : turn;
  };
  return std::ranges::any_of(mesh.cells, [&](const Mesh::Cell& cell) {
    const auto [least, most] = std::ranges::minmax(cell, {}, east_of_west);
    return east_of_west(most) - east_of_west(least) > 180.0;
  });
}

HorizontalGrid geographic_grid(const Mesh& mesh, const std::vector<geo::LonLat>& points, double spacing_m) {
  const geo::BoundingBox box = geo::bounding_box(points);
  const double height_deg = box.north_deg - box.south_deg;
  const double least_abs_lat =
      box.south_deg > 0.0 ? box.south_deg : (box.north_deg < 0.0 ? -box.north_deg : 0.0);
  const double lat_per_lon = std::cos(least_abs_lat * std::numbers::pi / 180.0);
  const double width = geo::width_deg(box);
  const double step = affordable_step(spacing_m / metres_per_lat_degree, width * lat_per_lon * height_deg);
  const double lat_step = rounded(step);
  const double lon_step = rounded(step / lat_per_lon);

  const double south = std::max(-90.0, start_before(box.south_deg, lat_step));
  std::vector<double> lats = nodes_between(south, box.north_deg, lat_step);
  if (lats.back() > 90.0) lats.back() = 90.0;
  if (width + 2.0 * lon_step < 360.0 && !closes_round(mesh, box)) {
    const double west = start_before(box.west_deg, lon_step);
    return {geo::GeographicFrame{}, Axis{nodes_between(west, box.west_deg + width, lon_step)},
            Axis{std::move(lats)}};
  }
  const double count = std::ceil(360.0 / lon_step);
  std::vector<double> lons(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < lons.size(); ++i) lons[i] = -180.0 + 360.0 * static_cast<double>(i) / count;
  return {geo::GeographicFrame{}, Axis{std::move(lons)}, Axis{std::move(lats)}};
}

/// The axis with each step divided into equal parts.
Axis divided(const Axis& axis, std::size_t parts) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    for (std::size_t part = 0; part < parts; ++part)
      nodes.push_back(axis[i] +
                      (axis[i + 1] - axis[i]) * static_cast<double>(part) / static_cast<double>(parts));
  nodes.push_back(axis.back());
  return Axis{std::move(nodes)};
}

}  // namespace

std::optional<HorizontalGrid> lattice_for(const Mesh& mesh) {
  const std::vector<geo::LonLat> points = used_points(mesh);
  const double spacing_m = quantile_of_sides_m(mesh, share_of_fine_sides);
  if (points.empty() || !(spacing_m > 0.0)) return std::nullopt;
  double least_lat = 90.0;
  double most_lat = -90.0;
  for (const geo::LonLat place : points) {
    least_lat = std::min(least_lat, place.lat_deg);
    most_lat = std::max(most_lat, place.lat_deg);
  }
  const bool polar = (least_lat > polar_above_lat_deg && most_lat > polar_from_lat_deg) ||
                     (most_lat < -polar_above_lat_deg && least_lat < -polar_from_lat_deg);
  return polar ? polar_grid(points, spacing_m) : geographic_grid(mesh, points, spacing_m);
}

std::size_t most_nodes_refined(const HorizontalGrid& lattice, std::size_t points) {
  if (lattice.wraps()) return lattice.size();
  const double fine = std::min(nodes_per_point * static_cast<double>(points), max_fine_nodes);
  return std::max(lattice.size(), static_cast<std::size_t>(fine));
}

HorizontalGrid refined(const HorizontalGrid& lattice, const Mesh& part) {
  if (lattice.wraps()) return lattice;  // the seam is a step, too, but on no axis
  const double wanted_m = half * quantile_of_sides_m(part, share_of_fine_sides);
  const double spacing_m = lattice.spacing().value;
  if (!(wanted_m > 0.0) || !(spacing_m > wanted_m)) return lattice;
  const auto most_nodes = static_cast<double>(most_nodes_refined(lattice, part.points.size()));
  const double affordable = std::sqrt(most_nodes / static_cast<double>(lattice.size()));
  const auto parts = static_cast<std::size_t>(std::min(std::ceil(spacing_m / wanted_m - 1e-9), affordable));
  if (parts < 2) return lattice;
  return {lattice.frame(), divided(lattice.x(), parts), divided(lattice.y(), parts)};
}

}  // namespace floeplan::ocean
