#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/iceberg_track_repository.hpp"

namespace floeplan::codec {

/// A sighting as a GeoJSON Feature; lengths that are not known are null.
[[nodiscard]] nlohmann::json iceberg_feature(const repository::StoredSighting& sighting);

/// A sighting from a GeoJSON Feature with a Point. Properties: berg_id and observed are required, size, length_m,
/// draft_m, position_uncertainty_m, shape and method may be there; others are left alone.
/// Errors   every violation, with its JSON pointer inside the feature
[[nodiscard]] tl::expected<ocean::Iceberg, core::Violations> parse_iceberg_feature(
    const nlohmann::json& feature);

/// The sightings of one berg as a line with the time of each of its places.
[[nodiscard]] nlohmann::json iceberg_track_feature(const repository::IcebergTrack& track);

}  // namespace floeplan::codec
