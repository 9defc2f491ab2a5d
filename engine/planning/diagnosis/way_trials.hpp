#pragma once

#include <cstdint>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea_shelf.hpp"
#include "engine/planning/diagnosis/relaxation.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The request for a trial, which asks only whether any route exists. Inputs that only make a route better
/// are dropped.
[[nodiscard]] PlanRequest for_any_way(const PlanRequest& request);

/// Tests whether requests on the same data have a plan at all. One limit on the work holds for all of them
/// together. Each may use a quarter of the remaining work, so a request that is hard to decide leaves work
/// for the others.
/// Law      if the answer is `possible`, `plan_route` finds a plan, too
/// Work     counted in timed legs and gridded data, about half a microsecond per unit. It is not measured by
///          a clock, so the same trials give the same answers on every machine
/// Threads  one at a time
class WayTrials {
 public:
  static constexpr std::int64_t standard_work = 16'000'000;

  /// `environment` is borrowed and must outlive the trials.
  WayTrials(const ocean::Environment& environment, const std::stop_token& stop,
            std::int64_t most_work = standard_work)
      : environment_{environment}, stop_{stop}, left_{most_work} {}

  /// Tests a request. Once `stop` is requested the answer is `not_known`.
  [[nodiscard]] TrialOutcome operator()(const PlanRequest& request);

  /// Remaining work. At the end it may be below zero by the work of the smallest search.
  [[nodiscard]] std::int64_t left() const { return left_; }

 private:
  [[nodiscard]] TrialOutcome within(cost::GridReach reach, const PlanRequest& request, std::int64_t& share);
  [[nodiscard]] std::int64_t work_of_a_chart(const PlanRequest& request, const cost::Layout& layout) const;

  const ocean::Environment& environment_;
  std::stop_token stop_;
  std::int64_t left_;
  cost::SeaShelf shelf_;  // most trials change only some of the obstacles, so the other parts are reused
};

}  // namespace floeplan::planning::diagnosis
