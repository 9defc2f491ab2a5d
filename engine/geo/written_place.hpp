#pragma once

#include <optional>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A place as files and people write it, with its longitude brought into [-180, 180). Maps that do not wrap count on to
/// either side of the antimeridian.
/// Outside  nothing where the longitude is not within [-360, 360] or the latitude not within [-90, 90]
[[nodiscard]] std::optional<LonLat> written_place(double lon_deg, double lat_deg);

}  // namespace floeplan::geo
