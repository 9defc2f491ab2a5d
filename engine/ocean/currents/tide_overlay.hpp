#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/currents/tide_grid.hpp"

namespace floeplan::ocean {

/// A period that includes both its ends.
struct TidePeriod {
  core::UtcTime from;
  core::UtcTime to;
};

/// The currents with the tide added, over their own period; if they have a single time, over `period`.
/// Time     in steps of at most `straight_step` that include the data's own times. If that exceeds 16 million
///          samples, the steps grow up to an hour; after that the period is cut short
[[nodiscard]] CurrentGrid with_tide(const CurrentGrid& currents, const std::vector<TideGrid>& models,
                                    const TidePeriod& period);

/// Only the tidal currents, over `period`, at the nodes of the first model with currents. Time as for
/// `with_tide`.
/// Errors  std::invalid_argument if no model has currents
[[nodiscard]] CurrentGrid tide_alone(const std::vector<TideGrid>& models, const TidePeriod& period);

}  // namespace floeplan::ocean
