#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::optimal_control {

/// Comparison of a route with the fastest route in open water.
struct Optimality {
  std::optional<double> gap;  // travel time over the least travel time, minus one
  std::string reason;         // for the pilot: why there is no gap; empty if there is one
};

/// Compares a route with the fastest route through its fixed points that is free of grid and number of legs. Two
/// candidates are searched, one near the route itself and one near the straight line; the faster one is the
/// reference.
/// No gap   The search ignores obstacles. There is no gap if the reference meets an obstacle or leaves the data, if
/// the search does not converge to a thousandth, or if the route is faster than the reference, which is then no
/// optimum
/// Accuracy 1e-3 of the travel time or better; a gap below the reached accuracy may be given as zero
/// Precondition  the route can be travelled from the epoch of the leg cost model on, at its speed through water
/// Stops    once `stop` is requested, without a gap
[[nodiscard]] Optimality rate_route(const cost::Sea& sea, const cost::Route& route,
                                    const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
