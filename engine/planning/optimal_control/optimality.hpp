#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::optimal_control {

/// How much longer a route takes than the best way that vehicle and currents allow.
struct Optimality {
  std::optional<double> gap;  // travel time over the least travel time, minus one
  std::string reason;         // for a pilot: why there is no gap; empty when there is one
};

/// Compares the route with the fastest way past its fixed points that is not bound to grid or number of legs:
/// the earlier one of those near the route itself and near the straight way. Obstacles are left out of that
/// search; where the way then meets one, or leaves the data, no gap is given. Nor is it where the search does
/// not settle to a thousandth, or where the route is the faster one, which then would not be compared with an
/// optimum.
/// Accuracy 1e-3 of the travel time or better; a gap smaller than the accuracy reached may come out as zero
/// Precondition  the route can be travelled from the sea's epoch on at its speed through the water
/// Stops    once `stop` is requested, without a gap
[[nodiscard]] Optimality rate_route(const cost::Sea& sea, const cost::Route& route,
                                    const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
