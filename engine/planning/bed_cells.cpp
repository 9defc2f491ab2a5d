#include "engine/planning/bed_cells.hpp"

#include "engine/planning/least_depth_rows.hpp"

namespace floeplan::planning {

BedCells::BedCells(const ocean::Bathymetry& bathymetry, core::Metres enough,
                   const geo::LocalProjection& projection, const PlaneBox& area, core::Metres cell,
                   const std::stop_token& stop)
    : raster_{area, cell} {
  least_m_.reserve(raster_.size());
  LeastDepthRows rows{raster_, bathymetry, enough, projection, stop};
  for (std::int64_t row = 0; row < raster_.ny() && !stop.stop_requested(); ++row) {
    const std::vector<float>& least_m = rows.next();
    least_m_.insert(least_m_.end(), least_m.begin(), least_m.end());
  }
  least_m_.resize(raster_.size());
}

bool BedCells::is_deep_at(geo::PlanePoint point, core::Metres depth) const {
  const auto cell = raster_.index(point);
  return cell && static_cast<double>(least_m_[*cell]) >= depth.value;
}

bool BedCells::is_deep_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const {
  bool deep = true;
  raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
    deep = raster_.holds(ix, iy) && static_cast<double>(least_m_[raster_.index(ix, iy)]) >= depth.value;
    return deep;
  });
  return deep;
}

}  // namespace floeplan::planning
