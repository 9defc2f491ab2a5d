#pragma once

#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/problem/refinement_report.hpp"
#include "engine/planning/refinement/refinement.hpp"

namespace floeplan::planning::publish {

/// A route with the propulsion of each leg after refinement, and the figures of the refinement.
struct RefinedDrive {
  cost::DrivenRoute route;
  RefinementReport report;
};

/// Moves the free points of a route off the grid until its cost by the objective stops falling. Each leg uses
/// the propulsion with which it costs least.
/// Returns  a route that is open as a whole. It costs at most `limits.tolerance` more than the given one,
///          unless `limits.most_legs` forces it to. If there is none, the given route
/// Stops    when the budget is used up, with the best route found until then
[[nodiscard]] RefinedDrive refine_drive(const cost::Sea& sea, const cost::DrivenRoute& route,
                                        const Objective& objective,
                                        const refinement::RefinementLimits& limits,
                                        const refinement::RefinementBudget& budget);

}  // namespace floeplan::planning::publish
