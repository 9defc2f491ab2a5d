#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// The mean of several realisations of the same currents, sample by sample; a sample that one of them misses is
/// missing.
/// Returns  empty where they are not on the same nodes of place, depth and time, or carry tides of their own
/// Errors   std::invalid_argument for none
[[nodiscard]] std::optional<CurrentGrid> ensemble_mean(
    const std::vector<std::shared_ptr<const CurrentGrid>>& members);

}  // namespace floeplan::ocean
