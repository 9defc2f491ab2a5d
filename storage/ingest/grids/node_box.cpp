#include "storage/ingest/grids/node_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floeplan::ingest {
namespace {

struct Extremes {
  double least{std::numeric_limits<double>::infinity()};
  double most{-std::numeric_limits<double>::infinity()};

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] double width() const { return most - least; }
};

struct Run {
  std::size_t first{};
  std::size_t count{};
};

Run nodes_within(const ocean::Axis& axis, double from, double to) {
  const auto& nodes = axis.nodes();
  const auto first = std::lower_bound(nodes.begin(), nodes.end(), from);
  const auto end = std::upper_bound(first, nodes.end(), to);
  return {static_cast<std::size_t>(first - nodes.begin()), static_cast<std::size_t>(end - first)};
}

/// Columns between two meridians, going on at the first column where the range passes the last.
Run columns_within(const ocean::Axis& lons, double from, double width) {
  const double start = from - 360.0 * std::floor((from - lons.front()) / 360.0);
  Run run = nodes_within(lons, start, start + width);
  const Run next_turn = nodes_within(lons, lons.front(), start + width - 360.0);
  if (run.count == 0) return next_turn;
  run.count = std::min(run.count + next_turn.count, lons.size());
  return run;
}

NodeBox geographic_box(const ocean::HorizontalGrid& grid, const SourceMesh& mesh,
                       const SourceMesh::Cell& cell) {
  Extremes lon;
  Extremes lat;
  double turned = 0.0;  // the way round the cell, by longitude
  const geo::LonLat first = mesh.points[cell[0]];
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const geo::LonLat corner = mesh.points[cell[i]];
    const geo::LonLat next = mesh.points[cell[(i + 1) % cell.size()]];
    lon.add(geo::longitude_difference(first.lon_deg, corner.lon_deg));
    lat.add(corner.lat_deg);
    turned += geo::longitude_difference(corner.lon_deg, next.lon_deg);
  }
  const bool round_a_pole = std::abs(turned) > 180.0 || lat.most > 89.999 || lat.least < -89.999;
  if (round_a_pole) {
    const bool north = lat.most > 0.0;
    const Run y = north ? nodes_within(grid.y(), lat.least - 1e-9, 90.0)
                        : nodes_within(grid.y(), -90.0, lat.most + 1e-9);
    return {0, grid.x().size(), y.first, y.count};
  }
  // Sides are great circles: between the corners they come nearer to the pole than the corners do.
  constexpr double radians = std::numbers::pi / 180.0;
  const double bulge = lon.width() * lon.width() * radians / 8.0 + 1e-6;
  const Run x = columns_within(grid.x(), first.lon_deg + lon.least - 1e-6, lon.width() + 2e-6);
  const Run y = nodes_within(grid.y(), lat.least - bulge, lat.most + bulge);
  return {x.first, x.count, y.first, y.count};
}

NodeBox projected_box(const ocean::HorizontalGrid& grid, const SourceMesh& mesh,
                      const SourceMesh::Cell& cell) {
  Extremes x;
  Extremes y;
  for (const std::uint32_t corner : cell) {
    const geo::GridPoint at = geo::to_grid(grid.frame(), mesh.points[corner]);
    x.add(at.x);
    y.add(at.y);
  }
  const double margin =
      0.1 * std::max(x.width(), y.width());  // straight sides are slightly bent on the plane
  const Run columns = nodes_within(grid.x(), x.least - margin, x.most + margin);
  const Run rows = nodes_within(grid.y(), y.least - margin, y.most + margin);
  return {columns.first, columns.count, rows.first, rows.count};
}

}  // namespace

NodeBox nodes_near(const ocean::HorizontalGrid& grid, const SourceMesh& mesh, const SourceMesh::Cell& cell) {
  return std::holds_alternative<geo::GeographicFrame>(grid.frame()) ? geographic_box(grid, mesh, cell)
                                                                    : projected_box(grid, mesh, cell);
}

}  // namespace floeplan::ingest
