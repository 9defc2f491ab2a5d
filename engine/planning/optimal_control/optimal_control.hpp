#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "engine/planning/optimal_control/way_descent.hpp"
#include "engine/planning/optimal_control/zermelo.hpp"

namespace floeplan::planning::optimal_control {

/// Times straight legs in a plane current, accurately enough for `descend`. Borrows the current.
template <motion::PlaneCurrent Current>
LegTimer legs_in(const Current& current, core::MetresPerSecond through_water) {
  constexpr double tolerance = 1e-6;
  return [&current, through_water](geo::PlanePoint from, geo::PlanePoint to,
                                   core::Seconds depart) -> std::optional<core::Seconds> {
    const core::Metres length{geo::distance_m(from, to)};
    const auto time = motion::edge_time({from, to, length}, depart, through_water, current,
                                        {.relative_tolerance = tolerance});
    return time ? std::optional{*time} : std::nullopt;
  };
}

/// The earliest of the extremals near some routes, which lead from start to goal through different corridors. `descend`
/// first moves each route close enough to an extremal for the Newton method of `solve_extremal`.
/// Accuracy 1e-6 of the duration or better in a current that is smooth over 1/512 of the route
/// Errors   where no route led to an extremal: why the last one did not
/// Stops    with NoExtremal::cancelled once `stop` is requested
template <motion::SlopedPlaneCurrent Current>
tl::expected<Extremal, NoExtremal> find_extremal(const Crossing& crossing, const Current& current,
                                                 const std::vector<std::vector<geo::PlanePoint>>& starts,
                                                 const std::stop_token& stop = {}) {
  constexpr std::size_t pieces = 64;
  constexpr double steps_of_piece = 8.0;
  const LegTimer leg_timer = legs_in(current, crossing.through_water);
  tl::expected<Extremal, NoExtremal> best = tl::unexpected(NoExtremal::outside_data);
  for (const std::vector<geo::PlanePoint>& points : starts) {
    const auto start = time_way(points, crossing.depart, leg_timer);
    if (!start) continue;
    const WayDescent bent = descend_with_legs(descend(*start, leg_timer, stop).way, pieces, leg_timer, stop);
    const auto guess = guess_along(bent.way, current, pieces);
    if (!guess) continue;
    const ZermeloFlow flow{current, crossing.through_water, guess->duration / (pieces * steps_of_piece)};
    auto extremal = solve_extremal(crossing, flow, *guess, stop);
    const bool better = extremal && best && extremal->duration < best->duration;
    if (better || !best) best = std::move(extremal);
  }
  return best;
}

}  // namespace floeplan::planning::optimal_control
