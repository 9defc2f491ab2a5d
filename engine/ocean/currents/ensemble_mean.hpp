#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// The mean of the members of an ensemble of currents, sample by sample. A sample that is missing in one
/// member is missing.
/// Returns  empty if their nodes in place, depth and time differ, or if a member has a tide
/// Errors   std::invalid_argument for no members
[[nodiscard]] std::optional<CurrentGrid> ensemble_mean(
    const std::vector<std::shared_ptr<const CurrentGrid>>& members);

}  // namespace floeplan::ocean
