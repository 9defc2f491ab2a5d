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
  std::string reason;         // for the pilot: why there is no gap; empty if there is one
};

/// Compares the route with the fastest way past its fixed points that is bound neither to the grid nor to a number of
/// legs. Two ways are looked for, near the route itself and near the straight line; the faster one counts.
/// No gap   The search ignores obstacles. There is no gap where the way found meets one or leaves the data, where the
///          search does not settle to a thousandth, and where the route is faster than the way found, which is then no
///          optimum
/// Accuracy 1e-3 of the travel time or better; a gap below the accuracy reached may be given as zero
/// Precondition  the route can be travelled from the sea's epoch on at its speed through the water
/// Stops    once `stop` is requested, without a gap
[[nodiscard]] Optimality rate_route(const cost::Sea& sea, const cost::Route& route,
                                    const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
