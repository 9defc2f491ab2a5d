#include "engine/ocean/bed/bathymetry.hpp"

#include <stdexcept>
#include <utility>

#include "engine/ocean/grids/bilinear.hpp"

namespace floeplan::ocean {

Bathymetry::Bathymetry(HorizontalGrid grid, std::vector<float> depth_m, std::vector<float> shoalest_m)
    : grid_{std::move(grid)}, depth_m_{std::move(depth_m)}, shoalest_m_{std::move(shoalest_m)} {
  if (depth_m_.size() != grid_.size() || (!shoalest_m_.empty() && shoalest_m_.size() != grid_.size()))
    throw std::invalid_argument{"bathymetry needs one depth for each node"};
}

std::optional<core::Metres> Bathymetry::depth(geo::LonLat place) const {
  const auto position = grid_.locate(place);
  if (!position) return std::nullopt;
  const auto depth_m = bilinear(depth_m_, grid_.x().size(), *position);
  if (!depth_m) return std::nullopt;
  return core::Metres{*depth_m};
}

std::optional<core::Metres> Bathymetry::shoalest(geo::LonLat place) const {
  return shoalest_at(grid_.projection().to_grid(place));
}

std::optional<core::Metres> Bathymetry::shoalest_at(geo::GridPoint point) const {
  const auto position = grid_.locate_point(point);
  if (!position) return std::nullopt;
  return shoalest_at(*position);
}

std::optional<core::Metres> Bathymetry::shoalest_at(const GridPosition& position) const {
  const std::size_t nx = grid_.x().size();
  const auto depth_m = bilinear(depth_m_, nx, position);
  if (!depth_m) return std::nullopt;
  if (shoalest_m_.empty()) return core::Metres{*depth_m};
  double least_m = *depth_m;
  for (const std::size_t iy : {position.y.lower, position.y.upper}) {
    for (const std::size_t ix : {position.x.lower, position.x.upper}) {
      const auto node_m = static_cast<double>(shoalest_m_[iy * nx + ix]);
      if (node_m < least_m) least_m = node_m;  // a missing node (NaN) compares as false
    }
  }
  return core::Metres{least_m};
}

}  // namespace floeplan::ocean
