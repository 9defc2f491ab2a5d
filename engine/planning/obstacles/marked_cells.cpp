#include "engine/planning/obstacles/marked_cells.hpp"

#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::obstacles {

MarkedCells::MarkedCells(const plane::PlaneRaster& raster, const std::vector<bool>& marked)
    : raster_{raster},
      distances_{marked, static_cast<std::size_t>(raster.nx()), core::Metres{raster.cell_m()}} {}

bool MarkedCells::may_meet(geo::PlanePoint a, geo::PlanePoint b) const {
  const double length_m = geo::distance_m(a, b);
  double way_m = 0.0;
  for (;;) {
    const auto cell = raster_.index(length_m > 0.0 ? plane::place_between(a, b, way_m / length_m) : a);
    if (!cell) return true;
    // So far in every direction there is no marked cell, so the line is followed that far in one step.
    const double clear_m = distances_.from(*cell).value;
    if (clear_m <= 0.0) return true;
    way_m += clear_m;
    if (way_m > length_m) return false;
  }
}

}  // namespace floeplan::planning::obstacles
