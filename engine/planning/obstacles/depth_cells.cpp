#include "engine/planning/obstacles/depth_cells.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/planning/obstacles/least_depth_rows.hpp"

namespace floeplan::planning::obstacles {
namespace {

CellState state_of(std::optional<motion::EdgeClosed> verdict) {
  if (!verdict) return CellState::open;
  if (*verdict == motion::EdgeClosed::on_land) return CellState::on_land;
  return *verdict == motion::EdgeClosed::too_shallow ? CellState::too_shallow : CellState::outside_data;
}

}  // namespace

std::optional<motion::EdgeClosed> judge_depth(std::optional<core::Metres> depth, core::Metres least_depth) {
  if (!depth) return motion::EdgeClosed::outside_data;
  if (depth->value <= 0.0) return motion::EdgeClosed::on_land;
  if (*depth < least_depth) return motion::EdgeClosed::too_shallow;
  return std::nullopt;
}

std::vector<CellState> judge_depths(const plane::PlaneRaster& raster, const ocean::Bathymetry& bathymetry,
                                    core::Metres least_depth, const geo::LocalProjection& projection,
                                    const std::stop_token& stop) {
  std::vector<CellState> cells;
  cells.reserve(raster.size());
  LeastDepthRows rows{raster, bathymetry, least_depth, projection, stop};
  for (std::int64_t row = 0; row < raster.ny() && !stop.stop_requested(); ++row) {
    std::ranges::transform(rows.next(), std::back_inserter(cells), [&](float least_m) {
      const auto known = std::isnan(least_m) ? std::nullopt : std::optional{core::Metres{least_m}};
      return state_of(judge_depth(known, least_depth));
    });
  }
  cells.resize(raster.size(), CellState::open);
  return cells;
}

}  // namespace floeplan::planning::obstacles
