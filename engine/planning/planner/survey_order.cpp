#include "engine/planning/planner/survey_order.hpp"

#include <algorithm>
#include <utility>

#include "engine/planning/planner/tour_legs.hpp"
#include "engine/planning/planner/visiting_order.hpp"
#include "engine/planning/search/chart.hpp"

namespace floeplan::planning::planner {
namespace {

constexpr core::Seconds at_once{0.0};

/// Share of the travel time. Where closures cost more than this, all orders are looked at once more.
constexpr double worth_another_look = 0.02;

/// Travel times by what the legs are asked for.
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

}  // namespace

std::optional<EstimatedOrder> best_via_order(const ocean::Environment& environment,
                                             const PlanRequest& request, const std::stop_token& stop) {
  const Result<search::Chart> chart =
      search::draw_chart(environment, request, cost::reaches(request).back(), stop);
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

std::vector<EstimatedOrder> promising_via_orders(const ocean::Environment& environment,
                                                 const PlanRequest& request, std::size_t most,
                                                 const std::stop_token& stop) {
  const Result<search::Chart> chart =
      search::draw_chart(environment, request, cost::reaches(request).back(), stop);
  if (!chart) return {};
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime past_closures = leg_times(legs, &TourLegs::time_past_closures);
  std::vector<EstimatedOrder> result;
  for (const VisitingOrder& order : best_visiting_orders_without_fifo(
           request.via.size(), at_once, past_closures, most, stop, estimates_of(legs)))
    result.push_back(estimated(order));
  return result;
}

}  // namespace floeplan::planning::planner
