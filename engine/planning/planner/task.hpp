#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/sea_shelf.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning::planner {

/// A request with its environment, stop token, progress callback and executor. All references are borrowed.
struct Task {
  const ocean::Environment& environment;
  const PlanRequest& request;
  const std::stop_token& stop;
  const core::ProgressCallback& progress;  // never empty
  const WiderSea& wider;                   // loads data of a larger area; empty: no further data
  cost::SeaShelf& shelf;                   // gridded parts that the plans of this task share
  const core::Executor& executor{core::in_order()};
  /// A search may leave out routes with longer travel times on the grid, because a better plan is known.
  core::Seconds of_use{INFINITY};
  /// A route that a plan may take if it finds no faster one; empty: none. Borrowed.
  std::span<const geo::LonLat> known_route{};

  /// A copy for another request.
  [[nodiscard]] Task with(const PlanRequest& other) const {
    return {environment, other, stop, progress, wider, shelf, executor, of_use, known_route};
  }
  /// A copy for another environment.
  [[nodiscard]] Task in(const ocean::Environment& other) const {
    return {other, request, stop, progress, wider, shelf, executor, of_use, known_route};
  }
  /// A copy that reports its progress to `other`, which is borrowed.
  [[nodiscard]] Task telling(const core::ProgressCallback& other) const {
    return {environment, request, stop, other, wider, shelf, executor, of_use, known_route};
  }
  /// A copy that looks only for plans that may be faster than `known`.
  [[nodiscard]] Task to_beat(const Plan& known) const {
    constexpr double gained_by_refinement = 0.03;  // share of the time on a grid: a judgement
    Task task = *this;
    if (request.objective().is_time()) task.of_use = (1.0 + gained_by_refinement) * known.travel_time();
    return task;
  }
  /// A copy for one of several parallel pieces of work: no progress reports, on one thread.
  [[nodiscard]] Task as_piece() const {
    return {environment, request,          stop,   silently().progress, wider,
            shelf,       core::in_order(), of_use, known_route};
  }
  /// A copy without progress reports.
  [[nodiscard]] Task silently() const {
    static const core::ProgressCallback silent = [](std::string_view, double) {};
    return {environment, request, stop, silent, wider, shelf, executor, of_use, known_route};
  }
};

/// Plans a task once.
/// Stops  with Reason::cancelled once `stop` is requested
using Planning = std::function<Result<Plan>(const Task&)>;

}  // namespace floeplan::planning::planner
