#include "api/codec/iceberg_feature.hpp"

#include <nlohmann/json.hpp>

#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

nlohmann::json optional_metres(const std::optional<core::Metres>& length) {
  return length ? nlohmann::json(length->value) : nlohmann::json();
}

}  // namespace

nlohmann::json iceberg_feature(const repository::StoredSighting& sighting) {
  const auto& berg = sighting.iceberg;
  return {{"type", "Feature"},
          {"id", sighting.row},
          {"geometry", {{"type", "Point"}, {"coordinates", {berg.place.lon_deg, berg.place.lat_deg}}}},
          {"properties",
           {{"berg_id", berg.id},
            {"observed", core::iso8601(berg.observed)},
            {"size", ocean::size_name(berg.size)},
            {"length_m", optional_metres(berg.length)},
            {"safe_length_m", ocean::safe_length(berg).value},
            {"draft_m", optional_metres(berg.draft)},
            {"position_uncertainty_m", optional_metres(berg.position_uncertainty)},
            {"shape", berg.shape},
            {"method", berg.method},
            {"dataset_id", sighting.dataset.value}}}};
}

}  // namespace floeplan::codec
