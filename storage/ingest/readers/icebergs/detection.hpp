#pragma once

#include <array>
#include <string>
#include <string_view>

#include "engine/ocean/ice/iceberg.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Names of the column or attribute in which a list of detections from satellites says how sure of each it is.
inline constexpr auto confidence_names =
    std::to_array<std::string_view>({"confidence", "probability", "score", "detection_confidence"});

/// Makes a sighting of a detection. Every detection counts as an iceberg, however unsure: its confidence, a share, a
/// percentage or a word, is kept beside the method for people to see. One without a name is named after its place and
/// time, so that no detection of a later image stands in for it.
/// Errors   a confidence below 0 or over 100
[[nodiscard]] Checked<ocean::Iceberg> as_detection(ocean::Iceberg iceberg, const std::string& confidence);

}  // namespace floeplan::ingest
