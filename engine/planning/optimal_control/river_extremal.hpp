#pragma once

#include "engine/core/units.hpp"
#include "engine/planning/currents/analytic_currents.hpp"

namespace floeplan::planning::optimal_control {

/// Least time to cross the river to the point straight opposite, by optimal control. In a flow that runs
/// along y and depends on x alone, Zermelo's equation keeps sin(phi) / (V + c sin(phi)) constant along an
/// extremal, so its heading phi (from the x axis) obeys sin(phi) = k V / (1 - k c(x)). The constant k is the
/// one that ends at the same y.
/// Accuracy 1e-9 s for the paper's river
/// Errors   std::invalid_argument when the vehicle is not faster than the river's peak
/// Source   Zermelo 1931, doi:10.1002/zamm.19310110205; Eichhorn 2009, equation (6)
[[nodiscard]] core::Seconds river_crossing_by_optimal_control(const currents::RiverCurrent& river,
                                                              core::MetresPerSecond through_water);

}  // namespace floeplan::planning::optimal_control
