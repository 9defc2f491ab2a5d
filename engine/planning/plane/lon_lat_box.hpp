#pragma once

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// The box of longitudes and latitudes round a rectangle of the plane, round the globe where a pole lies in it.
/// Accuracy  its rim is looked at 32 times a side: sides that bend between may reach a little further
[[nodiscard]] geo::BoundingBox lon_lat_box(const PlaneBox& box, const geo::LocalProjection& projection);

}  // namespace floeplan::planning::plane
