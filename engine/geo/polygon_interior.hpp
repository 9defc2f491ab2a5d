#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::geo {

/// Whether the place is inside the polygon or at most `tolerance_deg` from an edge of it or of its holes.
/// (`contains` includes only one of two opposite edges.)
[[nodiscard]] bool covers(const Polygon& polygon, LonLat place, double tolerance_deg);

/// A place well inside the polygon: the middle of a long stretch inside it, along a parallel between two
/// corners.
/// Outside  nullopt if the polygon encloses no area
[[nodiscard]] std::optional<LonLat> interior_point(const Polygon& polygon);

}  // namespace floeplan::geo
