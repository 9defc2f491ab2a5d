#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning::planner {

/// A request with its sea, its stop token and its listener. Everything is borrowed.
struct Task {
  const ocean::Environment& environment;
  const PlanRequest& request;
  const std::stop_token& stop;
  const core::ProgressCallback& progress;  // never empty
  const core::SteadyClock& clock;
  const WiderSea& wider;  // empty: the environment holds all that there is

  /// The same for another request.
  [[nodiscard]] Task with(const PlanRequest& other) const {
    return {environment, other, stop, progress, clock, wider};
  }
  /// The same in another sea.
  [[nodiscard]] Task in(const ocean::Environment& other) const {
    return {other, request, stop, progress, clock, wider};
  }
  /// The same, with another listener to its progress, which is borrowed.
  [[nodiscard]] Task telling(const core::ProgressCallback& other) const {
    return {environment, request, stop, other, clock, wider};
  }
  /// The same without a listener.
  [[nodiscard]] Task silently() const {
    static const core::ProgressCallback silent = [](std::string_view, double) {};
    return {environment, request, stop, silent, clock, wider};
  }
};

/// Plans a task once.
/// Stops  with Reason::cancelled once `stop` is requested
using Planning = std::function<Result<Plan>(const Task&)>;

}  // namespace floeplan::planning::planner
