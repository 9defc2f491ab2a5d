#pragma once

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// The polygon without the corners that matter beyond the box only: of a stretch of its outline that stays on one side
/// of the box, those are left that keep it there. What the outline of a continent costs then follows from the area that
/// is looked at.
/// Law      a place in the box is in the result if it is in the polygon, and only then; edges that reach into the box
///          are the polygon's own
/// Edges    an outline that nowhere reaches the box nor encloses it may be left with two corners, or one
[[nodiscard]] Polygon coarse_beyond(const BoundingBox& box, const Polygon& polygon);

}  // namespace floeplan::geo
