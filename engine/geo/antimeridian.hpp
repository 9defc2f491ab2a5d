#pragma once

#include <vector>

#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// The area of `polygon` in pieces for a chart from 180 W to 180 E: split where it crosses the antimeridian,
/// with the pole's parallel as an edge if it contains a pole. Lines stay straight in longitude and latitude.
/// Precondition  the outer ring runs counter-clockwise seen from above, holes clockwise; rings are simple and
///               do not touch; consecutive places of a ring are less than 180 degrees of longitude apart
/// Returns  outer rings counter-clockwise, holes clockwise, none crossing the antimeridian; longitudes in
///          [-180, 180]
/// Errors   std::runtime_error for a polygon that breaks the precondition so that it cannot be cut
/// Source   RFC 7946, sections 3.1.6 and 3.1.9; clipping by GEOS
[[nodiscard]] std::vector<Polygon> split_at_antimeridian(const Polygon& polygon);

}  // namespace floeplan::geo
