#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// Which cells of the raster areas to stay in hold the whole of: one of them, or several together that overlap or touch
/// (`touching_m`).
/// Bounds   so much work where areas meet in outlines of very many corners; cells that are not decided by then, or in
///          which no place is clear of every outline, count as not held
/// Stops    early once `stop` is requested; the answer is then incomplete
[[nodiscard]] std::vector<bool> cells_to_stay_in(const std::vector<geo::Polygon>& areas,
                                                 const plane::PlaneRaster& raster,
                                                 const geo::LocalProjection& projection,
                                                 const std::stop_token& stop);

}  // namespace floeplan::planning::obstacles
