#include "engine/planning/obstacles/plane_bed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::obstacles {

PlaneBed::PlaneBed(std::shared_ptr<const ocean::Bathymetry> bathymetry,
                   const geo::LocalProjection& projection, const plane::PlaneBox& area,
                   const std::stop_token& stop)
    : bathymetry_{std::move(bathymetry)}, grid_{bathymetry_->grid(), projection, area, stop} {}

std::optional<core::Metres> PlaneBed::depth(geo::PlanePoint point) const {
  const auto cell = grid_.corner(point);
  if (!cell) return std::nullopt;
  const std::size_t nx = grid_.nx();
  const std::size_t columns = bathymetry_->grid().x().size();
  const auto node = [&](std::size_t i) {
    return static_cast<double>(bathymetry_->shoalest_m()[grid_.row(i / nx) * columns + grid_.column(i % nx)]);
  };
  const std::size_t sw = cell->first;
  const double south = node(sw) + cell->fx * (node(sw + 1) - node(sw));
  const double north = node(sw + nx) + cell->fx * (node(sw + nx + 1) - node(sw + nx));
  const double depth_m = south + cell->fy * (north - south);
  if (std::isnan(depth_m)) return std::nullopt;
  if (!bathymetry_->knows_shoaler_cells()) return core::Metres{depth_m};
  return core::Metres{std::min({depth_m, node(sw), node(sw + 1), node(sw + nx), node(sw + nx + 1)})};
}

std::vector<double> PlaneBed::bends(geo::PlanePoint a, geo::PlanePoint b, core::Metres look) const {
  constexpr double most_looks = 65'536.0;
  constexpr double most_cells = 16.0;  // between samples; more only where longitudes jump, beyond a pole
  constexpr double apart = 1e-9;       // share of the line: closer bends count as one
  const double looks = std::clamp(std::ceil(geo::distance_m(a, b) / look.value), 1.0, most_looks);
  std::vector<double> shares;
  const auto add = [&](double share) {
    if (share > (shares.empty() ? 0.0 : shares.back()) + apart && share < 1.0 - apart)
      shares.push_back(share);
  };
  std::vector<double> borders;
  const auto add_borders = [&](double from, double until, double begins) {
    if (!(std::abs(until - from) <= most_cells)) return;
    const auto [low, high] = std::minmax(from, until);
    for (double line = std::ceil(low); line <= high && high > low; ++line)
      borders.push_back((begins + (line - from) / (until - from)) / looks);
  };
  auto here = grid_.place_among_nodes(a);
  for (double i = 0.0; i < looks; ++i) {
    const double share = (i + 1.0) / looks;
    const auto next = grid_.place_among_nodes(plane::place_between(a, b, share));
    borders.clear();
    if (here && next) {
      add_borders(here->x, next->x, i);
      add_borders(here->y, next->y, i);
    }
    std::ranges::sort(borders);
    for (const double border : borders) add(border);
    add(share);
    here = next;
  }
  shares.push_back(1.0);
  return shares;
}

core::Metres PlaneBed::least_depth() const {
  double least_m = INFINITY;
  const std::size_t columns = bathymetry_->grid().x().size();
  for (std::size_t iy = 0; iy < grid_.ny(); ++iy) {
    const float* row = bathymetry_->shoalest_m().data() + grid_.row(iy) * columns;
    for (std::size_t ix = 0; ix < grid_.nx(); ++ix) {
      const double depth_m = row[grid_.column(ix)];
      if (depth_m < least_m) least_m = depth_m;
    }
  }
  return {least_m};
}

}  // namespace floeplan::planning::obstacles
