#include "storage/ingest/readers/icebergs/detection.hpp"

#include <array>
#include <cstdio>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

Checked<ocean::Iceberg> as_detection(ocean::Iceberg iceberg, const std::string& confidence) {
  const auto value = parse_number(confidence);
  if (value && !(*value >= 0.0 && *value <= 100.0))
    return refuse(messages::ingest_iceberg_message<"confidence-impossible">(confidence));
  if (iceberg.id.empty()) {
    std::array<char, 64> place{};
    std::snprintf(place.data(), place.size(), "%.5f %.5f ", iceberg.place.lat_deg, iceberg.place.lon_deg);
    iceberg.id = "detection " + std::string{place.data()} + core::iso8601(iceberg.observed);
  }
  if (!confidence.empty())
    iceberg.method += (iceberg.method.empty() ? "" : ", ") + std::string{"confidence "} + confidence;
  return iceberg;
}

}  // namespace floeplan::ingest
