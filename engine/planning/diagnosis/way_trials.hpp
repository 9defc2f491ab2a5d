#pragma once

#include <cstdint>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/currents_shelf.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/diagnosis/relaxation.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The request as a trial takes it: whether there is any way, whatever would make one better.
[[nodiscard]] PlanRequest for_any_way(const PlanRequest& request);

/// Finds out of one request after the other in the same sea whether it has a plan at all, with a bounded amount of work
/// for all of them together: each may take a quarter of what is left, so that one that is hard to decide does not keep
/// the others from being tried.
/// Law      where the answer is `possible`, `plan_route` finds a plan, too
/// Work     counted in timed legs and laid out data, half a microsecond a unit, and not by a clock: the same trials
///          give the same answers on every machine
/// Threads  one at a time
class WayTrials {
 public:
  static constexpr std::int64_t standard_work = 16'000'000;

  /// `environment` is borrowed and outlives the trials.
  WayTrials(const ocean::Environment& environment, const std::stop_token& stop,
            std::int64_t most_work = standard_work)
      : environment_{environment}, stop_{stop}, left_{most_work}, shelf_{environment} {}

  /// `not_known` also once `stop` is requested.
  [[nodiscard]] TrialOutcome operator()(const PlanRequest& request);

  /// Of the work; below zero by no more than the least that a search does.
  [[nodiscard]] std::int64_t left() const { return left_; }

 private:
  [[nodiscard]] TrialOutcome within(cost::GridReach reach, const PlanRequest& request, std::int64_t& share);
  [[nodiscard]] std::int64_t work_of_a_chart(const PlanRequest& request, const cost::Layout& layout) const;

  const ocean::Environment& environment_;
  std::stop_token stop_;
  std::int64_t left_;
  cost::CurrentsShelf
      shelf_;  // most trials ask for what is above and in the way to change, not for the water
};

}  // namespace floeplan::planning::diagnosis
