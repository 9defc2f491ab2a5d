#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/currents/tide_grid.hpp"

namespace floeplan::ocean {

/// A period, both ends included.
struct TidePeriod {
  core::UtcTime from;
  core::UtcTime to;
};

/// The currents with the tide added: over their own period, or, when they have one time, over `period`.
/// Time     in steps of `straight_step` or a little less, so that they meet the data's own; where that would be more
///          than 16 million samples the steps grow up to an hour, and then the period ends earlier
[[nodiscard]] CurrentGrid with_tide(const CurrentGrid& currents, const std::vector<TideGrid>& models,
                                    const TidePeriod& period);

/// The tidal currents alone, at the nodes of the first model that has currents, over `period`, as above.
/// Errors  std::invalid_argument when no model has currents
[[nodiscard]] CurrentGrid tide_alone(const std::vector<TideGrid>& models, const TidePeriod& period);

}  // namespace floeplan::ocean
