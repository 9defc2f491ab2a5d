#pragma once

#include <cmath>
#include <functional>
#include <stop_token>
#include <string_view>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning::planner {

/// A request with its sea, its stop token, its listener and its threads. Everything is borrowed.
struct Task {
  const ocean::Environment& environment;
  const PlanRequest& request;
  const std::stop_token& stop;
  const core::ProgressCallback& progress;  // never empty
  const WiderSea& wider;                   // empty: the environment holds all that there is
  const core::Executor& executor{core::in_order()};
  /// A way on a grid that takes longer is of no use, because a better plan is known.
  core::Seconds of_use{INFINITY};

  /// The same for another request.
  [[nodiscard]] Task with(const PlanRequest& other) const {
    return {environment, other, stop, progress, wider, executor, of_use};
  }
  /// The same in another sea.
  [[nodiscard]] Task in(const ocean::Environment& other) const {
    return {other, request, stop, progress, wider, executor, of_use};
  }
  /// The same, with another listener to its progress, which is borrowed.
  [[nodiscard]] Task telling(const core::ProgressCallback& other) const {
    return {environment, request, stop, other, wider, executor, of_use};
  }
  /// The same where a plan is known that another one is to beat.
  [[nodiscard]] Task to_beat(const Plan& known) const {
    constexpr double gained_by_refinement = 0.03;  // of the time on a grid: a judgement
    Task task = *this;
    if (request.objective().is_time()) task.of_use = (1.0 + gained_by_refinement) * known.travel_time();
    return task;
  }
  /// The same as one of several pieces of work: without a listener, and on one thread.
  [[nodiscard]] Task as_piece() const {
    return {environment, request, stop, silently().progress, wider, core::in_order(), of_use};
  }
  /// The same without a listener.
  [[nodiscard]] Task silently() const {
    static const core::ProgressCallback silent = [](std::string_view, double) {};
    return {environment, request, stop, silent, wider, executor, of_use};
  }
};

/// Plans a task once.
/// Stops  with Reason::cancelled once `stop` is requested
using Planning = std::function<Result<Plan>(const Task&)>;

}  // namespace floeplan::planning::planner
