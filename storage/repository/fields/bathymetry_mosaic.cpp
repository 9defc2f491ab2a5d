#include "storage/repository/fields/bathymetry_mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

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
  const ocean::HorizontalGrid& nodes = layer.grid();
  for (std::size_t iy = 0; iy < nodes.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < nodes.x().size(); ++ix) {
      const std::size_t node = iy * nodes.x().size() + ix;
      const float depth_m = layer.depth_m()[node];
      if (std::isnan(depth_m)) continue;
      const auto cell = cell_of(nodes.place(ix, iy));
      if (!cell || !std::isnan(depth_m_[*cell])) continue;
      cells[*cell].sum_m += static_cast<double>(depth_m);
      ++cells[*cell].count;
      cells[*cell].least_m = std::min({cells[*cell].least_m, depth_m, layer.shoalest_m()[node]});
    }
  }

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
