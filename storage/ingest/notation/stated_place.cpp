#include "storage/ingest/notation/stated_place.hpp"

#include <cmath>

#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

std::optional<messages::Message> fault_of_place(geo::LonLat place) {
  constexpr int digits = 12;  // enough to see that a place lies beyond a pole
  if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg))
    return messages::ingest_area_message<"position-missing">();
  if (std::abs(place.lat_deg) > 90.0)
    return messages::ingest_area_message<"latitude-beyond-pole">(number(place.lat_deg, digits));
  if (std::abs(place.lon_deg) > 360.0)
    return messages::ingest_area_message<"longitude-out-of-range">(number(place.lon_deg, digits));
  return std::nullopt;
}

}  // namespace floeplan::ingest
