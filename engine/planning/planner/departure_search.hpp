#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <tuple>
#include <vector>

#include "engine/core/executor.hpp"
#include "engine/core/units.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// The result of one departure in a search area of one size.
struct Journey {
  core::Seconds arrival{};
  core::Joules energy{};
  double cost{};  // by the request's objective
  bool touches_rim{false};

  /// For core::packed.
  friend auto members_of(Journey& journey) {
    auto& [arrival, energy, cost, touches_rim] = journey;
    return std::tie(arrival, energy, cost, touches_rim);
  }
};

/// The result for each departure in one environment. Departures after a requested stop are cancelled.
/// The search areas and their grids are made once for all departures.
/// `ended`  called with the number of finished departures
[[nodiscard]] std::vector<Result<Journey>> leave_all(const std::vector<core::UtcTime>& departures,
                                                     const ocean::Environment& environment,
                                                     const PlanRequest& request, const std::stop_token& stop,
                                                     const core::Executor& executor,
                                                     const std::function<void(std::size_t)>& ended);

}  // namespace floeplan::planning::planner
