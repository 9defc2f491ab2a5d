#include "engine/simulation/ice_layer.hpp"

namespace floeplan::simulation {
IceLayer::IceLayer(const ocean::Environment& environment, const geo::LocalProjection& projection,
                   const planning::PlaneBox& area, core::UtcTime epoch)
    : epoch_{epoch},
      cover_{planning::IceCovers{environment, planning::UnderIceRules{}, projection, area, epoch}},
      area_{area} {}

}  // namespace floeplan::simulation
