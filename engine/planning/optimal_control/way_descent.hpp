#pragma once

#include <stop_token>

#include "engine/planning/optimal_control/timed_way.hpp"

namespace floeplan::planning::optimal_control {

/// The result of a descent.
struct WayDescent {
  TimedWay way;
  bool converged{false};  // no small move of a point across the route lowers the duration
  bool closed{false};     // not converged, because a leg that had to be tried cannot be travelled
};

/// Moves the inner points of a route across its course until its duration no longer falls. Start, goal and the number of
/// legs stay. Method: Newton's, on all points at once, by differential dynamic programming. The stages are the legs, and the
/// state is a point's offset and the time there, so that a step costs about a dozen evaluations for each leg.
/// Law      the duration never grows
/// Accuracy if converged: by the quadratic model less than 1e-7 of the duration can still be gained
/// Source   Jacobson and Mayne 1970, Differential Dynamic Programming
/// Stops    once `stop` is requested, then not converged
[[nodiscard]] WayDescent descend(const TimedWay& start, const LegTimer& leg_timer,
                                 const std::stop_token& stop = {});

/// `descend` with `legs` legs of about equal duration. The route is divided into them before the descent, and
/// again after it. Not converged if the divided route, which cuts corners, is closed.
[[nodiscard]] WayDescent descend_with_legs(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                                           const std::stop_token& stop = {});

/// A rough descent. Its result is the first route of a descent with more legs. The route is divided once. The
/// descent ends when the quadratic model predicts a gain of less than 1e-4 of the duration.
[[nodiscard]] WayDescent descend_roughly(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                                         const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
