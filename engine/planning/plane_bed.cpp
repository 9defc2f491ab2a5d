#include "engine/planning/plane_bed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace floeplan::planning {

PlaneBed::PlaneBed(std::shared_ptr<const ocean::Bathymetry> bathymetry,
                   const geo::LocalProjection& projection, const PlaneBox& area, const std::stop_token& stop)
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

}  // namespace floeplan::planning
