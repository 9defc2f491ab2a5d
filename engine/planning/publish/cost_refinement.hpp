#pragma once

#include <cstddef>
#include <optional>

#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/problem/refinement_report.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::publish {

/// A driven route after its points were moved and what that did.
struct RefinedDrive {
  cost::DrivenRoute route;
  RefinementReport report;
};

/// Moves the free points of a route off the grid until what it costs by the objective stops falling, each leg on the
/// drive on which it costs least.
/// `most_legs`  of the result; empty: as many as serve
/// Returns  a route that is open as a whole and costs no more than the one that came, unless `most_legs` forces it; the
///          one that came where there is none
/// Stops    when the budget ends, with the best found until then
[[nodiscard]] RefinedDrive refine_drive(const cost::Sea& sea, const cost::DrivenRoute& route,
                                        const Objective& objective, std::optional<std::size_t> most_legs,
                                        const refinement::RefinementBudget& budget);

}  // namespace floeplan::planning::publish
