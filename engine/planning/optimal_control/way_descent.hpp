#pragma once

#include <stop_token>

#include "engine/planning/optimal_control/timed_way.hpp"

namespace floeplan::planning::optimal_control {

/// What moving the points of a way led to.
struct WayDescent {
  TimedWay way;
  bool converged{false};  // no small move of a point across the way makes it shorter in time
  bool closed{false};     // not converged, because a leg that had to be tried cannot be travelled
};

/// Moves the inner points of a way across its course until its duration no longer falls; start, goal and
/// the number of legs stay. Newton's method on all points at once, by differential dynamic programming: the
/// stages are the legs, the state is a point's offset and the time there, so that a step costs about a
/// dozen evaluations for each leg, however many there are.
/// Law      the duration never grows
/// Accuracy converged: by the quadratic model less than 1e-7 of the duration is left to gain
/// Source   Jacobson and Mayne 1970, Differential Dynamic Programming
/// Stops    once `stop` is requested, then not converged
[[nodiscard]] WayDescent descend(const TimedWay& start, const LegTimer& leg_timer,
                                 const std::stop_token& stop = {});

/// The same with so many legs of equal duration, near enough: the way is cut anew, and once more when it has
/// moved. Not converged when cutting the way's corners closes it.
[[nodiscard]] WayDescent descend_with_legs(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                                           const std::stop_token& stop = {});

/// The same, cut anew once, until by the quadratic model less than 1e-4 of the duration is left to gain: a start for
/// more legs.
[[nodiscard]] WayDescent descend_roughly(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                                         const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
