#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/messages/refusal_messages.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/planner/strategy_plans.hpp"
#include "engine/planning/planner/tour_legs.hpp"
#include "engine/planning/planner/visiting_order.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {
namespace {

/// An order of the via points, and the travel time of its route as estimated on coarse grids.
struct EstimatedOrder {
  ViaOrder order;
  core::Seconds travel_time{};
};

constexpr core::Seconds at_once{0.0};

/// If closures delay the tour by more than this share of its travel time, all orders are compared again with
/// closures.
constexpr double worth_another_look = 0.02;

/// Travel times of legs by one of the time functions of `TourLegs`.
TourLegTime leg_times(TourLegs& legs, auto time) {
  return [&legs, time](std::size_t from, std::size_t to, core::Seconds depart) {
    return (legs.*time)(from, to, depart);
  };
}

LegEstimates estimates_of(TourLegs& legs) {
  return {.least = [&legs](std::size_t from, std::size_t to) { return legs.least_time(from, to); },
          .usual = [&legs](std::size_t from, std::size_t to) { return legs.usual_time(from, to); }};
}

EstimatedOrder estimated(const VisitingOrder& order) {
  EstimatedOrder result{{{}, order.exact}, order.arrival};
  for (const std::size_t place : order.places) result.order.vias.push_back(place - 1);
  return result;
}

/// The order of the via points with the earliest estimated arrival; empty if no order leads to the goal or
/// `stop` is requested.
std::optional<EstimatedOrder> best_via_order(const Task& task) {
  const PlanRequest& request = task.request;
  const std::stop_token& stop = task.stop;
  const Result<search::Chart> chart =
      search::draw_chart(task.environment, request, cost::reaches(request).back(), stop, &task.shelf);
  if (!chart) return std::nullopt;
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime past_closures = leg_times(legs, &TourLegs::time_past_closures);
  auto order = best_visiting_order(request.via.size(), at_once, leg_times(legs, &TourLegs::time), stop,
                                   estimates_of(legs));
  if (!order) return std::nullopt;
  const auto flown = end_of_tour(order->places, at_once, past_closures);
  const bool is_as_early = flown && *flown <= (1.0 + worth_another_look) * order->arrival;
  if (flown) order->arrival = *flown;
  if (is_as_early) return estimated(*order);
  const auto orders = best_visiting_orders_without_fifo(request.via.size(), at_once, past_closures, 1, stop,
                                                        estimates_of(legs));
  const bool is_better = !orders.empty() && (!flown || orders.front().arrival < *flown);
  return estimated(is_better ? orders.front() : *order);
}

/// Orders that are likely to reach the goal early; for callers that found no plan in the best order, which
/// may be among them. With more than five via points at most one.
/// `most`   largest number of orders, at least one
/// Returns  the earliest first; fewer once `stop` is requested
std::vector<EstimatedOrder> promising_via_orders(const Task& task, std::size_t most) {
  const PlanRequest& request = task.request;
  const std::stop_token& stop = task.stop;
  const Result<search::Chart> chart =
      search::draw_chart(task.environment, request, cost::reaches(request).back(), stop, &task.shelf);
  if (!chart) return {};
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime past_closures = leg_times(legs, &TourLegs::time_past_closures);
  std::vector<EstimatedOrder> result;
  for (const VisitingOrder& order : best_visiting_orders_without_fifo(
           request.via.size(), at_once, past_closures, most, stop, estimates_of(legs)))
    result.push_back(estimated(order));
  return result;
}

/// Relative error of travel times on coarse grids. A plan that exceeds it met something that they do not show.
constexpr double accuracy = 0.03;

/// Number of orders planned in addition to the best one. A judgement: each takes a whole plan. With a limit
/// on the time without surfacing a plan may take a minute, so fewer are made.
constexpr std::size_t most_other_orders = 4;
constexpr std::size_t most_other_orders_with_surfacings = 1;

ViaOrder order_given(const PlanRequest& request) {
  ViaOrder order{std::vector<std::size_t>(request.via.size()), false};
  std::iota(order.vias.begin(), order.vias.end(), std::size_t{0});
  return order;
}

/// Plans one order after another, and keeps the plan with the earliest arrival.
class SurveyPlans {
 public:
  SurveyPlans(const Task& task, const Planning& plan_in_order)
      : task_{task}, plan_in_order_{plan_in_order}, parts_{task.progress, "order of visits"} {}

  /// Plans in this order, unless this order was planned before.
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

  /// The earliest plan; if there is none, the reason in the given order, which is always tried.
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
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  progress("order of visits", 0.0);
  const auto first = best_via_order(task);
  const bool minds_time = request.energy.objective.is_time() && request.objective().of_encounters == 0.0;
  const bool bounds_surfacing = request.under_ice.max_time_without_surfacing.has_value();
  SurveyPlans plans{task, plan_in_order};
  if (first && !stop.stop_requested()) plans.plan(first->order);

  const core::Seconds promised = first ? (1.0 + accuracy) * first->travel_time : core::Seconds{0.0};
  if (first && plans.is_later_than(minds_time ? promised : core::Seconds{INFINITY})) {
    const std::size_t others = bounds_surfacing ? most_other_orders_with_surfacings : most_other_orders;
    bool may_be_later = true;  // whether an untried order may be earlier than the best plan
    for (const EstimatedOrder& other : promising_via_orders(task, 1 + others)) {
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
