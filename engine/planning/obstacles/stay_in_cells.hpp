#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// Which cells of the raster lie completely inside the stay-in areas: inside one of them, or inside several
/// together that overlap or touch (`touching_m`).
/// Bounds   the work is limited for areas that meet in outlines of very many corners. Cells undecided by then
///          count as outside; so do cells in which every reference place lies on an outline
/// Stops    early once `stop` is requested; the result is then incomplete
[[nodiscard]] std::vector<bool> cells_to_stay_in(const std::vector<geo::Polygon>& areas,
                                                 const plane::PlaneRaster& raster,
                                                 const geo::LocalProjection& projection,
                                                 const std::stop_token& stop);

}  // namespace floeplan::planning::obstacles
