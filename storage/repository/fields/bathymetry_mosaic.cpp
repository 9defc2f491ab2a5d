#include "storage/repository/fields/bathymetry_mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "storage/repository/fields/grid_window.hpp"

namespace floeplan::repository {
namespace {

constexpr double metres_per_degree = 111'195.0;  // on a sphere of 6371 km; the grid need not be exact
constexpr float no_depth = std::numeric_limits<float>::quiet_NaN();
constexpr float none = std::numeric_limits<float>::infinity();

/// Nodes from `low` to `high` or just beyond.
ocean::Axis nodes_between(double low, double high, double step) {
  std::vector<double> nodes;
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil((high - low) / step - 1e-9)));
  for (std::size_t i = 0; i <= steps; ++i) nodes.push_back(low + step * static_cast<double>(i));
  return ocean::Axis{std::move(nodes)};
}

ocean::HorizontalGrid grid_over(const geo::BoundingBox& area, core::Metres spacing, std::size_t most_nodes) {
  if (!(spacing.value > 0.0)) throw std::invalid_argument{"a mosaic needs a spacing above 0 m"};
  const double width = std::max(geo::width_deg(area), 1e-6);
  const double height = std::max(area.north_deg - area.south_deg, 1e-6);
  const double middle = 0.5 * (area.south_deg + area.north_deg) * std::numbers::pi / 180.0;
  double dy = spacing.value / metres_per_degree;
  double dx = dy / std::max(std::cos(middle), 0.05);
  const double nodes = (width / dx + 1.0) * (height / dy + 1.0);
  const double coarser = std::max(1.0, std::sqrt(nodes / static_cast<double>(most_nodes)));
  dx *= coarser;
  dy *= coarser;
  const double south = std::max(area.south_deg - dy, -90.0);
  const double north = std::min(area.north_deg + dy, 90.0);
  // Around the whole globe, the last column must not coincide with the first.
  const double east = std::min(width + 2.0 * dx, 360.0 - dx);
  const ocean::Axis y = nodes_between(0.0, north - south, std::min(dy, north - south));
  std::vector<double> latitudes;
  for (const double node : y.nodes()) latitudes.push_back(std::min(south + node, 90.0));
  if (latitudes.size() > 1 && latitudes.back() <= latitudes[latitudes.size() - 2]) latitudes.pop_back();
  return {geo::GeographicFrame{}, nodes_between(area.west_deg - dx, area.west_deg - dx + east, dx),
          ocean::Axis{std::move(latitudes)}};
}

/// Calls `visit` with the index and the place of each node. In a projection, places between every fifteenth node are
/// interpolated where that misses the place in the middle by at most `most_missed`: a survey has 10^8 nodes, and
/// the formulas of a projection take a microsecond.
template <class Visit>
void for_each_place(const ocean::HorizontalGrid& nodes, geo::LonLat most_missed, const Visit& visit) {
  const ocean::Axis& x = nodes.x();
  const ocean::Axis& y = nodes.y();
  const auto exactly = [&](const NodeRun& columns, const NodeRun& rows) {
    for (std::size_t iy = rows.first; iy < rows.first + rows.count; ++iy)
      for (std::size_t ix = columns.first; ix < columns.first + columns.count; ++ix)
        visit(iy * x.size() + ix, nodes.place(ix, iy));
  };
  if (std::holds_alternative<geo::GeographicFrame>(nodes.frame()))
    return exactly({0, x.size()}, {0, y.size()});

  constexpr std::size_t side = 16;
  for (std::size_t south = 0; south < y.size(); south += side) {
    for (std::size_t west = 0; west < x.size(); west += side) {
      const NodeRun columns{west, std::min(side, x.size() - west)};
      const NodeRun rows{south, std::min(side, y.size() - south)};
      const std::size_t east = west + columns.count - 1;
      const std::size_t north = south + rows.count - 1;
      const geo::LonLat corner = nodes.place(west, south);
      // from the first corner, so that longitudes do not jump
      const auto beside = [&](std::size_t ix, std::size_t iy) {
        const geo::LonLat place = nodes.place(ix, iy);
        return geo::LonLat{geo::longitude_difference(corner.lon_deg, place.lon_deg),
                           place.lat_deg - corner.lat_deg};
      };
      const geo::LonLat se = beside(east, south);
      const geo::LonLat nw = beside(west, north);
      const geo::LonLat ne = beside(east, north);
      const auto between = [&](std::size_t ix, std::size_t iy) {
        const double fx = ix == west ? 0.0 : (x[ix] - x[west]) / (x[east] - x[west]);
        const double fy = iy == south ? 0.0 : (y[iy] - y[south]) / (y[north] - y[south]);
        const auto bilinear = [&](double a, double b, double c) {
          return fx * (1.0 - fy) * a + (1.0 - fx) * fy * b + fx * fy * c;
        };
        return geo::LonLat{bilinear(se.lon_deg, nw.lon_deg, ne.lon_deg),
                           bilinear(se.lat_deg, nw.lat_deg, ne.lat_deg)};
      };
      const std::size_t middle_x = west + columns.count / 2;
      const std::size_t middle_y = south + rows.count / 2;
      const geo::LonLat found = beside(middle_x, middle_y);
      const geo::LonLat guess = between(middle_x, middle_y);
      const bool is_near = std::abs(found.lon_deg - guess.lon_deg) <= most_missed.lon_deg &&
                           std::abs(found.lat_deg - guess.lat_deg) <= most_missed.lat_deg;
      if (!is_near) {
        exactly(columns, rows);
        continue;
      }
      for (std::size_t iy = south; iy <= north; ++iy) {
        for (std::size_t ix = west; ix <= east; ++ix) {
          const geo::LonLat here = between(ix, iy);
          visit(iy * x.size() + ix,
                geo::LonLat{corner.lon_deg + here.lon_deg, corner.lat_deg + here.lat_deg});
        }
      }
    }
  }
}

}  // namespace

BathymetryMosaic::BathymetryMosaic(const geo::BoundingBox& area, core::Metres spacing, std::size_t most_nodes)
    : grid_{grid_over(area, spacing, most_nodes)},
      depth_m_(grid_.size(), no_depth),
      shoalest_m_(grid_.size(), no_depth),
      fringe_m_(grid_.size(), none),
      unknown_{grid_.size()} {}

std::optional<std::size_t> BathymetryMosaic::cell_of(geo::LonLat place) const {
  const auto& x = grid_.x();
  const auto& y = grid_.y();
  const double dx = x[1] - x[0];
  const double dy = y[1] - y[0];
  const double turn = std::floor((place.lon_deg - (x.front() - 0.5 * dx)) / 360.0);
  const double column = std::round((place.lon_deg - 360.0 * turn - x.front()) / dx);
  const double row = std::round((place.lat_deg - y.front()) / dy);
  const bool is_inside = column >= 0.0 && column < static_cast<double>(x.size()) && row >= 0.0 &&
                         row < static_cast<double>(y.size());  // false for a node without a place (NaN)
  if (!is_inside) return std::nullopt;
  return static_cast<std::size_t>(row) * x.size() + static_cast<std::size_t>(column);
}

bool BathymetryMosaic::add(const ocean::Bathymetry& layer) {
  struct Cell {
    double sum_m{};
    std::uint32_t count{};
    float least_m{none};
  };
  std::vector<Cell> cells(grid_.size());
  constexpr double hair = 0.01;  // of a cell
  const geo::LonLat most_missed{hair * (grid_.x()[1] - grid_.x()[0]), hair * (grid_.y()[1] - grid_.y()[0])};
  for_each_place(layer.grid(), most_missed, [&](std::size_t node, geo::LonLat place) {
    const float depth_m = layer.depth_m()[node];
    if (std::isnan(depth_m)) return;
    const auto cell = cell_of(place);
    if (!cell || !std::isnan(depth_m_[*cell])) return;
    cells[*cell].sum_m += static_cast<double>(depth_m);
    ++cells[*cell].count;
    cells[*cell].least_m = std::min({cells[*cell].least_m, depth_m, layer.shoalest_m()[node]});
  });

  bool used = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!std::isnan(depth_m_[i])) continue;
    const Cell& cell = cells[i];
    const geo::LonLat place = grid_.place(i % grid_.x().size(), i / grid_.x().size());
    const auto here = layer.shoalest(place);
    fringe_m_[i] = std::min(fringe_m_[i], cell.least_m);
    used = used || here || cell.count > 0;
    if (!here) continue;
    depth_m_[i] =
        static_cast<float>(cell.count > 0 ? cell.sum_m / cell.count : layer.depth(place).value().value);
    shoalest_m_[i] = std::min({depth_m_[i], static_cast<float>(here->value), fringe_m_[i]});
    --unknown_;
  }
  return used;
}

}  // namespace floeplan::repository
