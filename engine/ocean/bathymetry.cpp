#include "engine/ocean/bathymetry.hpp"

#include <stdexcept>
#include <utility>

#include "engine/ocean/bilinear.hpp"

namespace floeplan::ocean {

Bathymetry::Bathymetry(HorizontalGrid grid, std::vector<float> depth_m)
    : grid_{std::move(grid)}, depth_m_{std::move(depth_m)} {
  if (depth_m_.size() != grid_.size())
    throw std::invalid_argument{"bathymetry needs one depth for each node"};
}

std::optional<core::Metres> Bathymetry::depth(geo::LonLat place) const {
  const auto position = grid_.locate(place);
  if (!position) return std::nullopt;
  const auto depth_m = bilinear(depth_m_, grid_.x().size(), *position);
  if (!depth_m) return std::nullopt;
  return core::Metres{*depth_m};
}

}  // namespace floeplan::ocean
