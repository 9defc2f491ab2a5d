#pragma once

#include <array>
#include <string>
#include <string_view>

#include "engine/ocean/ice/iceberg.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Names of the column or attribute with the confidence of a detection from satellite images.
inline constexpr auto confidence_names =
    std::to_array<std::string_view>({"confidence", "probability", "score", "detection_confidence"});

/// Completes a sighting that comes from a detection. Every detection counts as an iceberg, however low its
/// confidence, which is stored with the method for people to see (a fraction, a percentage or a word). A
/// detection without a name is named after its position and time, so that a detection in a later image does
/// not replace it.
/// Errors   a confidence below 0 or over 100
[[nodiscard]] Checked<ocean::Iceberg> as_detection(ocean::Iceberg iceberg, const std::string& confidence);

}  // namespace floeplan::ingest
