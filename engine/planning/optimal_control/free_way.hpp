#pragma once

#include <stop_token>
#include <tl/expected.hpp>

#include "engine/planning/optimal_control/timed_way.hpp"

namespace floeplan::planning::optimal_control {

/// The limit that the fastest routes near a given route approach as their number of legs grows.
struct FreeWay {
  TimedWay way;              // the route with the most legs
  core::Seconds duration{};  // of the limit, which is a smooth curve
  double accuracy{};         // relative error of the duration: the change by the last doubling of the legs
};

/// Why no limit was found.
enum class NoFreeWay {
  closed,       // the route would lead over legs that cannot be travelled
  not_settled,  // the durations do not converge to a thousandth
  cancelled
};

/// Moves the route `start` towards the fastest route near it, with 16 legs. Few legs are timed quickly, so
/// long moves cost little. If the legs cannot be travelled at this length, the result is `start`.
[[nodiscard]] TimedWay find_rough_free_way(const TimedWay& start, const LegTimer& leg_timer,
                                           const std::stop_token& stop = {});

/// Whether two rough routes lie within a quarter of a leg of each other along their whole length. Their limits then
/// differ by less than the required accuracy.
[[nodiscard]] bool lead_to_one_way(const TimedWay& a, const TimedWay& b);

/// The fastest route of 64 legs near the route `start`: the first step of `find_free_way`. It shows which
/// limit the search approaches, and the search can begin with it.
/// Stops    with NoFreeWay::cancelled once `stop` is requested
[[nodiscard]] tl::expected<TimedWay, NoFreeWay> find_coarse_free_way(const TimedWay& rough,
                                                                     const LegTimer& leg_timer,
                                                                     const std::stop_token& stop = {});

/// The fastest route near the route `start`, with any number of legs. `descend` runs with 64, 128 and 256
/// legs. The errors of the durations fall with the square of the leg length, so Richardson's extrapolation
/// gives the limit. It needs no derivatives of the current, so gridded data with kinks at their nodes can be
/// used.
/// Accuracy as the result says; about 1e-6 in the paper's jet, as a formula or on a grid. The error of the current
/// itself is not included
/// Source   Richardson 1911, doi:10.1098/rsta.1911.0009
/// Stops    with NoFreeWay::cancelled once `stop` is requested
[[nodiscard]] tl::expected<FreeWay, NoFreeWay> find_free_way(const TimedWay& start, const LegTimer& leg_timer,
                                                             const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
