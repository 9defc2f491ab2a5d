#pragma once

#include <stop_token>

#include "engine/planning/timed_route.hpp"

namespace floeplan::planning {

/// What moving the points of a route led to.
struct Descent {
  TimedRoute route;
  bool converged{false};  // no small move of a point across the route makes it shorter in time
};

/// Moves the inner points of a route across its course until its duration no longer falls; start, goal and
/// the number of legs stay. Newton's method on all points at once, by differential dynamic programming: the
/// stages are the legs, the state is a point's offset and the time there, so that a step costs about a
/// dozen evaluations for each leg, however many there are.
/// Law      the duration never grows
/// Accuracy converged: by the quadratic model less than 1e-7 of the duration is left to gain
/// Source   Jacobson and Mayne 1970, Differential Dynamic Programming
/// Stops    once `stop` is requested, then not converged
[[nodiscard]] Descent descend(const TimedRoute& start, const LegTime& leg_time,
                              const std::stop_token& stop = {});

/// The same with so many legs of equal duration, near enough: the route is cut anew, and once more when it has
/// moved. Not converged when cutting the route's corners closes it.
[[nodiscard]] Descent descend_with_legs(const TimedRoute& start, std::size_t legs, const LegTime& leg_time,
                                        const std::stop_token& stop = {});

}  // namespace floeplan::planning
