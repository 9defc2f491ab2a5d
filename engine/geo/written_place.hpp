#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A place as files and people write it, with its longitude wrapped to [-180, 180). Maps without a wrap
/// continue to count on either side of the antimeridian.
/// Outside  empty if the longitude is outside [-360, 360] or the latitude outside [-90, 90]
[[nodiscard]] std::optional<LonLat> written_place(double lon_deg, double lat_deg);

}  // namespace floeplan::geo
