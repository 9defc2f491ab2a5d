#pragma once

#include <stop_token>
#include <tl/expected.hpp>

#include "engine/planning/optimal_control/timed_way.hpp"

namespace floeplan::planning::optimal_control {

/// What ever more legs lead to, near the start.
struct FreeWay {
  TimedWay way;              // of the finest legs
  core::Seconds duration{};  // of the limit, where legs are bent
  double accuracy{};         // of the duration, relative: what the last doubling of the legs changed
};

/// Why there is no such way to show.
enum class NoFreeWay {
  closed,       // it would lead where legs cannot be travelled
  not_settled,  // the durations do not tend to a limit to better than a thousandth
  cancelled
};

/// A way of 16 legs towards the fastest one near the start, or the start where legs so long cannot be travelled: far
/// steps are taken with few legs, which are soon timed.
[[nodiscard]] TimedWay find_rough_free_way(const TimedWay& start, const LegTimer& leg_timer,
                                           const std::stop_token& stop = {});

/// Whether two rough ways lie within a quarter of a leg of each other all along: what they lead to differs by less than
/// what is asked of a limit.
[[nodiscard]] bool lead_to_one_way(const TimedWay& a, const TimedWay& b);

/// The fastest way near the start of the 64 legs that `find_free_way` begins with: it tells where that will lead, and
/// is a good start for it.
/// Stops    with NoFreeWay::cancelled once `stop` is requested
[[nodiscard]] tl::expected<TimedWay, NoFreeWay> find_coarse_free_way(const TimedWay& rough,
                                                                     const LegTimer& leg_timer,
                                                                     const std::stop_token& stop = {});

/// The fastest way near the start when its points are free and as many as one likes: `descend` with 64, 128
/// and 256 legs, whose durations err with the square of a leg's length; the limit by Richardson's
/// extrapolation. Needs no derivatives of the current, so that data with kinks between their nodes will do.
/// Accuracy as the result says; about 1e-6 in the paper's jet, as a formula or laid on a grid; of the current
///          as given: how well it stands for the sea is not part of it
/// Source   Richardson 1911, doi:10.1098/rsta.1911.0009
/// Stops    with NoFreeWay::cancelled once `stop` is requested
[[nodiscard]] tl::expected<FreeWay, NoFreeWay> find_free_way(const TimedWay& start, const LegTimer& leg_timer,
                                                             const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
