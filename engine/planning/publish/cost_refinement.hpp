#pragma once

#include <cstddef>
#include <optional>

#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/problem/refinement_report.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::publish {

/// A driven route after refinement, and what refinement did.
struct RefinedDrive {
  cost::DrivenRoute route;
  RefinementReport report;
};

/// Moves the free points of a route off the grid until its cost by the objective stops falling. Each leg takes the drive on
/// which it costs least.
/// `most_legs`  the largest number of legs of the result; empty: as many as lower the cost
/// Returns  a route that is open as a whole. It costs no more than the given one, unless `most_legs` forces it to. Where
///          there is none, the given route
/// Stops    when the budget ends, with the best found until then
[[nodiscard]] RefinedDrive refine_drive(const cost::Sea& sea, const cost::DrivenRoute& route,
                                        const Objective& objective, std::optional<std::size_t> most_legs,
                                        const refinement::RefinementBudget& budget);

}  // namespace floeplan::planning::publish
