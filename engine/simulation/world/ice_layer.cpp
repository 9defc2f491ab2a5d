#include "engine/simulation/world/ice_layer.hpp"

namespace floeplan::simulation {
IceLayer::IceLayer(const ocean::Environment& environment, const planning::UnderIceRules& rules,
                   const geo::LocalProjection& projection, const planning::plane::PlaneBox& area,
                   core::UtcTime epoch)
    : epoch_{epoch},
      cover_{planning::ice::IceCovers{environment, rules, projection, area, epoch}},
      area_{area} {}

}  // namespace floeplan::simulation
