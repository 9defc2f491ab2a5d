#pragma once

#include <optional>
#include <stop_token>

#include "engine/core/clock.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning::publish {

/// The route to publish and what its refinement did.
struct Improved {
  cost::Route route;
  std::optional<RefinementReport> refinement;
};

/// What is done to the way of a grid before it is published: needless points dropped, the others moved, their
/// number cut and long legs parted as the request has it.
/// A refined route that is closed as a whole is given up for the straightened one, and that for the way itself.
/// Stops  refinement once `clock` has gone on by the request's `refine_time` or `stop` is requested
[[nodiscard]] Improved improve(const cost::Sea& sea, const cost::Route& way, const PlanRequest& request,
                               const std::stop_token& stop, const core::SteadyClock& clock);

}  // namespace floeplan::planning::publish
