#pragma once

#include <optional>
#include <span>

#include "engine/geo/bounding_box.hpp"

namespace floeplan::geo {

/// The smallest box around all boxes, independent of their order: the circle of longitudes without the widest
/// gap between the boxes. It may cross the antimeridian.
/// Errors   std::invalid_argument for no boxes
[[nodiscard]] BoundingBox united(std::span<const BoundingBox> boxes);

/// Whether `outer` contains all of `inner`.
[[nodiscard]] bool holds(const BoundingBox& outer, const BoundingBox& inner);

/// Share of `inner` that lies in `outer`, in [0, 1]: share of its longitudes times share of its latitudes.
/// Each share is 1 for a single meridian or parallel inside.
[[nodiscard]] double share_held(const BoundingBox& outer, const BoundingBox& inner);

/// The longitudes and latitudes that both boxes share; nullopt if there are none. If two boxes meet on both
/// sides of the globe, the result would be two pieces. Then it is `a` with the shared latitudes.
[[nodiscard]] std::optional<BoundingBox> shared(const BoundingBox& a, const BoundingBox& b);

}  // namespace floeplan::geo
