#pragma once

#include <optional>
#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A place as files and people write it, with its longitude wrapped to [-180, 180). Maps without a wrap
/// continue to count on either side of the antimeridian.
/// Outside  empty if the longitude is outside [-360, 360] or the latitude outside [-90, 90]
[[nodiscard]] std::optional<LonLat> written_place(double lon_deg, double lat_deg);

/// A latitude as pilots read it, in degrees and decimal minutes: "67°12.000′N". Rounded to 0.001′ (2 m).
[[nodiscard]] std::string latitude_text(double lat_deg);

/// A longitude as pilots read it, wrapped to [-180, 180): "013°12.411′E". Rounded to 0.001′.
[[nodiscard]] std::string longitude_text(double lon_deg);

}  // namespace floeplan::geo
