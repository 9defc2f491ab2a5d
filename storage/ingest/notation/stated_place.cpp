#include "storage/ingest/notation/stated_place.hpp"

#include <cmath>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

std::string fault_of_place(geo::LonLat place) {
  constexpr int digits = 12;  // enough to see that a place lies beyond a pole
  if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg)) return "the position is missing";
  if (std::abs(place.lat_deg) > 90.0)
    return "the latitude " + number(place.lat_deg, digits) + " lies beyond a pole";
  if (std::abs(place.lon_deg) > 360.0)
    return "the longitude " + number(place.lon_deg, digits) + " is not within -360 and 360";
  return {};
}

}  // namespace floeplan::ingest
