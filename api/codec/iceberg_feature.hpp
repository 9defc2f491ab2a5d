#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/iceberg_repository.hpp"

namespace floeplan::codec {

/// A sighting as a GeoJSON Feature (Point). Every property is always there, null when not known.
[[nodiscard]] nlohmann::json iceberg_feature(const repository::StoredSighting& sighting);

}  // namespace floeplan::codec
