#pragma once

#include <cstdint>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/currents_shelf.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/diagnosis/relaxation.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The request as a trial sees it: whether there is any route. Inputs that only make a route better are dropped.
[[nodiscard]] PlanRequest for_any_way(const PlanRequest& request);

/// Finds out whether each of several requests in the same waters has a plan at all, with a limit on the work for all
/// of them together. Each may use a quarter of the work that is left, so a request that is hard to decide does not
/// prevent the others from being tried.
/// Law      if the answer is `possible`, `plan_route` finds a plan too
/// Work     counted in timed legs and gridded data, half a microsecond per unit, and not by a clock: the same trials
///          give the same answers on every machine
/// Threads  one at a time
class WayTrials {
 public:
  static constexpr std::int64_t standard_work = 16'000'000;

  /// `environment` is borrowed and must outlive the trials.
  WayTrials(const ocean::Environment& environment, const std::stop_token& stop,
            std::int64_t most_work = standard_work)
      : environment_{environment}, stop_{stop}, left_{most_work}, shelf_{environment} {}

  /// The answer is `not_known`, too, once `stop` is requested.
  [[nodiscard]] TrialOutcome operator()(const PlanRequest& request);

  /// Work that is left; below zero by no more than the smallest search takes.
  [[nodiscard]] std::int64_t left() const { return left_; }

 private:
  [[nodiscard]] TrialOutcome within(cost::GridReach reach, const PlanRequest& request, std::int64_t& share);
  [[nodiscard]] std::int64_t work_of_a_chart(const PlanRequest& request, const cost::Layout& layout) const;

  const ocean::Environment& environment_;
  std::stop_token stop_;
  std::int64_t left_;
  cost::CurrentsShelf shelf_;  // most trials change what is above or in the way, not the water
};

}  // namespace floeplan::planning::diagnosis
