#include "engine/planning/obstacles/bed_cells.hpp"

#include <algorithm>
#include <utility>

#include "engine/planning/obstacles/least_depth_rows.hpp"
#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::obstacles {
namespace {

/// Distance between samples along a line. Between the nodes of the data the bed curves by only centimetres
/// over it.
constexpr core::Metres look{25.0};

}  // namespace

BedCells::BedCells(std::shared_ptr<const ocean::Bathymetry> bathymetry, core::Metres enough,
                   const geo::LocalProjection& projection, const plane::PlaneBox& area, core::Metres cell,
                   const std::stop_token& stop)
    : bed_{bathymetry, projection, area, stop}, raster_{area, cell} {
  least_m_.reserve(raster_.size());
  LeastDepthRows rows{raster_, *bathymetry, enough, projection, stop};
  for (std::int64_t row = 0; row < raster_.ny() && !stop.stop_requested(); ++row) {
    const std::vector<float>& least_m = rows.next();
    least_m_.insert(least_m_.end(), least_m.begin(), least_m.end());
  }
  least_m_.resize(raster_.size());
}

bool BedCells::is_deep_at(geo::PlanePoint point, core::Metres depth) const {
  if (has_deep_cells_along(point, point, depth)) return true;
  const auto bed = bed_.depth(point);
  return bed && *bed >= depth;
}

bool BedCells::is_deep_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const {
  if (has_deep_cells_along(a, b, depth)) return true;
  const auto is_deep = [&](double share) {
    const auto bed = bed_.depth(plane::place_between(a, b, share));
    return bed && *bed >= depth;
  };
  if (!is_deep(0.0)) return false;
  double last = 0.0;
  for (const double bend : bed_.bends(a, b, look)) {
    if (!is_deep(0.5 * (last + bend)) || !is_deep(bend)) return false;
    last = bend;
  }
  return true;
}

bool BedCells::has_deep_cells_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const {
  bool deep = true;
  raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    deep = raster_.holds(ix, iy) && static_cast<double>(least_m_[raster_.index(ix, iy)]) >= depth.value;
    return deep;
  });
  return deep;
}

std::shared_ptr<const BedCells> lay_out_bed(std::shared_ptr<const ocean::Bathymetry> bathymetry,
                                            const vehicle::GliderProfile& vehicle,
                                            const geo::LocalProjection& projection,
                                            const plane::PlaneBox& area, core::Metres cell,
                                            const std::stop_token& stop) {
  const core::Metres enough = std::max(vehicle.dive_depth + vehicle.altimeter_margin, vehicle.least_water());
  return std::make_shared<const BedCells>(std::move(bathymetry), enough, projection, area, cell, stop);
}

}  // namespace floeplan::planning::obstacles
