#pragma once

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// The polygon with fewer corners outside the box. If a stretch of its outline stays on one side of the box,
/// only those corners are kept that hold it on that side. So work with a continent's outline depends on the
/// area of interest, not on the continent.
/// Law      a place in the box is in the result exactly if it is in the polygon; edges that reach into the
///          box are the polygon's own
/// Edges    an outline that neither reaches the box nor encloses it may be left with only one or two corners
[[nodiscard]] Polygon coarse_beyond(const BoundingBox& box, const Polygon& polygon);

}  // namespace floeplan::geo
