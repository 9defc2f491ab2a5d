#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The places at which a dataset saw an iceberg, in the order of time. Of several sightings at one time, only the
/// one stored last.
/// `from`, `before`  only sightings at or after `from` and before `before`; empty: no limit
[[nodiscard]] std::vector<ocean::IcebergFix> iceberg_fixes(sql::Connection& db, const DatasetId& dataset,
                                                           const std::string& berg_id,
                                                           std::optional<core::UtcTime> from = {},
                                                           std::optional<core::UtcTime> before = {});

}  // namespace floeplan::repository
