#include "engine/planning/survey_order.hpp"

#include "engine/planning/chart.hpp"
#include "engine/planning/tour_legs.hpp"
#include "engine/planning/visiting_order.hpp"

namespace floeplan::planning {

std::optional<ViaOrder> best_via_order(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop) {
  const Result<Chart> chart = draw_chart(environment, request, second_reach, stop);
  if (!chart) return std::nullopt;
  TourLegs legs{chart->sea, chart->layout, request, stop};
  const TourLegTime leg_time = [&](std::size_t from, std::size_t to, core::Seconds depart) {
    return legs.time(from, to, depart);
  };
  const auto order = best_visiting_order(request.via.size(), core::Seconds{0.0}, leg_time, stop);
  if (!order) return std::nullopt;
  ViaOrder result{{}, order->exact};
  for (const std::size_t place : order->places) result.vias.push_back(place - 1);
  return result;
}

}  // namespace floeplan::planning
