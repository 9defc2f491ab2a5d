#include "engine/planning/planner/survey_plan.hpp"

#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/planner/survey_order.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {
namespace {

/// Relative error of travel times on coarse grids. A plan that exceeds it met something that they do not show.
constexpr double accuracy = 0.03;

/// The number of orders that are planned in addition to the best one. A judgement: each takes a whole plan, which with a bound
/// on the time without surfacing may need a minute.
constexpr std::size_t most_other_orders = 4;
constexpr std::size_t most_other_orders_with_surfacings = 1;

ViaOrder order_given(const PlanRequest& request) {
  ViaOrder order{std::vector<std::size_t>(request.via.size()), false};
  std::iota(order.vias.begin(), order.vias.end(), std::size_t{0});
  return order;
}

/// Plans one order after the other, and keeps the earliest plan.
class SurveyPlans {
 public:
  SurveyPlans(const Task& task, const Planning& plan_in_order)
      : task_{task}, plan_in_order_{plan_in_order}, parts_{task.progress, "order of visits"} {}

  /// Plans in this order, unless it was planned before.
  void plan(const ViaOrder& order) {
    for (const std::vector<std::size_t>& before : tried_)
      if (before == order.vias) return;
    tried_.push_back(order.vias);
    PlanRequest ordered = task_.request;
    ordered.via_in_best_order = false;
    for (std::size_t i = 0; i < order.vias.size(); ++i) ordered.via[i] = task_.request.via[order.vias[i]];
    const core::ProgressCallback part = parts_.next();
    Result<Plan> plan = plan_in_order_(task_.with(ordered).telling(part));
    if (plan) plan->via_order = order;
    if (plan && best_ && best_->arrival <= plan->arrival) return;
    if (plan) {
      best_ = std::move(*plan);
    } else if (order.vias == order_given(task_.request).vias) {
      why_not_as_given_ = std::move(plan.error());
    }
  }

  [[nodiscard]] bool is_later_than(core::Seconds travel_time) const {
    return !best_ || best_->travel_time() > travel_time;
  }

  /// The earliest plan; where there is none, why there is none in the given order, which is always tried.
  [[nodiscard]] Result<Plan> best() && {
    if (best_) return std::move(*best_);
    if (tried_.size() > 1) {
      why_not_as_given_.besides.push_back(messages::refusal<"other-orders-tried">(tried_.size() - 1));
    }
    return tl::unexpected(std::move(why_not_as_given_));
  }

 private:
  const Task& task_;
  const Planning& plan_in_order_;
  core::PartsOfProgress parts_;
  std::vector<std::vector<std::size_t>> tried_;
  std::optional<Plan> best_;
  Infeasible why_not_as_given_;
};

}  // namespace

Result<Plan> plan_survey(const Task& task, const Planning& plan_in_order) {
  const auto& [environment, request, stop, progress, wider, executor, of_use] = task;
  progress("order of visits", 0.0);
  const auto first = best_via_order(environment, request, stop);
  const bool minds_time = request.energy.objective.is_time() && request.objective().of_encounters == 0.0;
  const bool bounds_surfacing = request.under_ice.max_time_without_surfacing.has_value();
  SurveyPlans plans{task, plan_in_order};
  if (first && !stop.stop_requested()) plans.plan(first->order);

  const core::Seconds promised = first ? (1.0 + accuracy) * first->travel_time : core::Seconds{0.0};
  if (first && plans.is_later_than(minds_time ? promised : core::Seconds{INFINITY})) {
    const std::size_t others = bounds_surfacing ? most_other_orders_with_surfacings : most_other_orders;
    bool may_be_later = true;  // whether an order that was not tried yet may be earlier
    for (const EstimatedOrder& other : promising_via_orders(environment, request, 1 + others, stop)) {
      may_be_later = !stop.stop_requested() && plans.is_later_than(other.travel_time);
      if (!may_be_later) break;
      plans.plan(other.order);
    }
    if (may_be_later && !stop.stop_requested()) plans.plan(order_given(request));
  }
  if (!first && !stop.stop_requested()) plans.plan(order_given(request));
  if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  return std::move(plans).best();
}

}  // namespace floeplan::planning::planner
