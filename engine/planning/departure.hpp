#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/strong_currents.hpp"

namespace floeplan::planning {

/// What leaving at one moment leads to.
struct DepartureOutcome {
  core::UtcTime departure;
  std::optional<core::Seconds> travel_time{};  // of one grid's way, before refinement; empty: there is none
  std::optional<core::Joules> energy{};        // drawn on that way; empty likewise
  std::optional<Infeasible> closed{};          // why there is none
  /// What a robust objective counts of the costs of the best ways in all members, which one way for all of them cannot
  /// undercut; of a departure that was planned, of its plan's way. Infinite where too few have one, empty without such
  /// an objective.
  std::optional<double> robust_cost{};
  std::size_t members_closed{};  // in which there is no way, with such an objective

  [[nodiscard]] core::UtcTime arrival() const { return departure + travel_time.value(); }
};

/// Plans for each departure of the request's window, as for this departure alone but for the refinement: the earliest
/// arrival, or the least cost where the objective asks for it.
/// Exact for every departure: the curve has no gaps, so none is left out because it cannot win. The way of one
/// departure bounds the search for the next, which changes no result.
/// Returns  an outcome for each departure, in their order
/// Errors   Reason::cancelled alone, within 100 ms of a request of `stop`
/// Throws   std::invalid_argument when `request.violations()` is not empty
[[nodiscard]] Result<std::vector<DepartureOutcome>> compare_departures(
    const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop,
    const core::ProgressCallback& progress);

/// A window's outcomes and the plan for the best of its departures: the plan for this departure alone. Its travel
/// time may be less than the curve's, because only this way is refined. A departure of which no plan comes although
/// there is a way, for want of battery, say, counts as closed. With a robust objective departures are planned until
/// none that is left may be better, six at most: then the best of those, with a warning.
struct WindowPlan {
  std::vector<DepartureOutcome> departures;
  Result<Plan> plan;  // the reason of the best departure, or of the first one when every one is closed
};

/// `clock` and `wider`: as plan_route's. Where no departure has a plan for currents as fast as the vehicle, all are
/// compared with more room.
[[nodiscard]] WindowPlan plan_window(const ocean::Environment& environment, const PlanRequest& request,
                                     const std::stop_token& stop, const core::ProgressCallback& progress,
                                     const core::SteadyClock& clock = {}, const WiderSea& wider = {});

/// The departure that costs least by the objective, the first of equals; with a robust objective of those that most
/// members let through. Empty when every one is closed.
[[nodiscard]] std::optional<std::size_t> best_departure(const std::vector<DepartureOutcome>& outcomes,
                                                        const Objective& objective = time_objective);

}  // namespace floeplan::planning
