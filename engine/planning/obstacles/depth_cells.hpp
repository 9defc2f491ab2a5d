#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/obstacles/cell_state.hpp"
#include "engine/planning/plane/plane_raster.hpp"

namespace floeplan::planning::obstacles {

/// What a depth means to a vehicle that needs `least_depth`; empty: it may be there. Unknown depths are closed.
[[nodiscard]] std::optional<motion::EdgeClosed> judge_depth(std::optional<core::Metres> depth,
                                                            core::Metres least_depth);

/// Judges each cell by the least depth in it (`LeastDepthRows`).
/// Stops    early once `stop` is requested; the states are then incomplete
[[nodiscard]] std::vector<CellState> judge_depths(const plane::PlaneRaster& raster,
                                                  const ocean::Bathymetry& bathymetry,
                                                  core::Metres least_depth,
                                                  const geo::LocalProjection& projection,
                                                  const std::stop_token& stop);

}  // namespace floeplan::planning::obstacles
