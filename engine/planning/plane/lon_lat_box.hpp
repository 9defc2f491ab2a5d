#pragma once

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// The box of longitudes and latitudes around a rectangle of the plane. It spans all longitudes if a pole
/// lies inside.
/// Accuracy  32 points on each side are converted: between them a side that bends may reach slightly beyond
///           the box
[[nodiscard]] geo::BoundingBox lon_lat_box(const PlaneBox& box, const geo::LocalProjection& projection);

}  // namespace floeplan::planning::plane
