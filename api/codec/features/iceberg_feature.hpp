#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/iceberg_track_repository.hpp"

namespace floeplan::codec {

/// A sighting as a GeoJSON Feature; unknown lengths are null.
[[nodiscard]] nlohmann::json iceberg_feature(const repository::StoredSighting& sighting);

/// Reads a sighting from a GeoJSON Feature with a Point. The properties berg_id and observed are required;
/// size, length_m, draft_m, position_uncertainty_m, shape and method are optional; others are ignored.
/// Errors   every violation, with its JSON pointer inside the feature
[[nodiscard]] tl::expected<ocean::Iceberg, core::Violations> parse_iceberg_feature(
    const nlohmann::json& feature);

/// The track of one berg as a line with the time of each position.
[[nodiscard]] nlohmann::json iceberg_track_feature(const repository::IcebergTrack& track);

}  // namespace floeplan::codec
