#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "storage/repository/features/zone_repository.hpp"

namespace floeplan::codec {

/// A stored zone as a GeoJSON Feature.
[[nodiscard]] nlohmann::json zone_feature(const repository::StoredZone& stored);

/// Reads a zone from a GeoJSON Feature with one Polygon. zone_inputs.hpp describes its properties.
/// Errors   every violation, with its JSON pointer inside the feature
[[nodiscard]] tl::expected<ocean::Zone, core::Violations> parse_zone_feature(const nlohmann::json& feature);

}  // namespace floeplan::codec
