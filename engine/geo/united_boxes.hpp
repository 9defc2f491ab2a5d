#pragma once

#include <optional>
#include <span>

#include "engine/geo/bounding_box.hpp"

namespace floeplan::geo {

/// The smallest box round all of them, in whatever order they come: what is left of the circle of longitudes after its
/// widest gap between the boxes is taken out; across the antimeridian where that is shorter.
/// Errors   std::invalid_argument without any box
[[nodiscard]] BoundingBox united(std::span<const BoundingBox> boxes);

/// Whether all of `inner` lies in `outer`.
[[nodiscard]] bool holds(const BoundingBox& outer, const BoundingBox& inner);

/// How much of `inner` lies in `outer`, in [0, 1]: the product of the shares of its longitudes and of its latitudes,
/// each of which is 1 for a meridian or a parallel inside.
[[nodiscard]] double share_held(const BoundingBox& outer, const BoundingBox& inner);

/// The longitudes and latitudes of both boxes; nullopt: they share none. Two pieces (of boxes that meet at the front
/// and at the back of the globe) are not told apart: then `a` with the latitudes of both.
[[nodiscard]] std::optional<BoundingBox> shared(const BoundingBox& a, const BoundingBox& b);

}  // namespace floeplan::geo
