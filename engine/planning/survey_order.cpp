#include "engine/planning/survey_order.hpp"

#include <utility>

#include "engine/planning/chart.hpp"
#include "engine/planning/tour_legs.hpp"
#include "engine/planning/visiting_order.hpp"

namespace floeplan::planning {

std::optional<ViaOrder> best_via_order(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop) {
  const Result<Chart> chart = draw_chart(environment, request, second_reach, stop);
  if (!chart) return std::nullopt;
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime any = [&](std::size_t from, std::size_t to, core::Seconds depart) {
    return legs.time(from, to, depart);
  };
  const TourLegTime bearable = [&](std::size_t from, std::size_t to, core::Seconds depart) {
    return legs.bearable_time(from, to, depart);
  };
  constexpr core::Seconds at_once{0.0};
  auto order = best_visiting_order(request.via.size(), at_once, any, stop);
  if (order && !end_of_tour(order->places, at_once, bearable)) {
    if (auto flown = best_visiting_order_without_fifo(request.via.size(), at_once, bearable, stop))
      order = std::move(flown);
  }
  if (!order) return std::nullopt;
  ViaOrder result{{}, order->exact};
  for (const std::size_t place : order->places) result.vias.push_back(place - 1);
  return result;
}

}  // namespace floeplan::planning
