#pragma once

#include <utility>

#include "engine/planning/refinement/cost_gradient.hpp"
#include "engine/planning/refinement/hat_basis.hpp"
#include "engine/planning/refinement/minimiser.hpp"

namespace floeplan::planning::refinement {

/// Result of a descent.
struct DescentResult {
  cost::Itinerary itinerary;  // never costs more than the start
  bool met_closed{false};     // a route with a closed leg was tried: closures may be in the way
};

/// Moves all free points at once down the gradient of the cost. The number of legs stays.
template <cost::CostedLeg Leg>
DescentResult descend_gradient(LegMeter<Leg>& legs, cost::Itinerary start, double relative_tolerance) {
  const cost::Route& from = start.route;
  const HatBasis basis{start};
  const std::size_t hats = basis.hats().size();
  DescentResult best{start, false};
  if (hats == 0 || !(start.travel_time().count() > 0.0) || !(start.cost() > 0.0)) return best;

  // The units of the hats assume costs in seconds, so the cost is converted.
  const double scale = start.travel_time().count() / start.cost();
  const auto cost = [&](std::span<const double> x, std::span<double> gradient) -> std::optional<double> {
    const std::vector<double> shift_x = basis.shifts(x.first(hats));
    const std::vector<double> shift_y = basis.shifts(x.last(hats));
    cost::Route moved = from;
    for (std::size_t i = 0; i < moved.points.size(); ++i) {
      moved.points[i].x_m += shift_x[i];
      moved.points[i].y_m += shift_y[i];
    }
    auto timed = legs.timed(std::move(moved), start.times.front());
    if (!timed) {
      best.met_closed = true;
      return std::nullopt;
    }
    CostGradient by_shift = cost_gradient(legs, *timed);
    basis.derive(std::move(by_shift.x), gradient.first(hats));
    basis.derive(std::move(by_shift.y), gradient.last(hats));
    for (double& by_coefficient : gradient) by_coefficient *= scale;
    const double scaled = scale * timed->cost();
    if (timed->cost() < best.itinerary.cost()) best.itinerary = std::move(*timed);
    return scaled;
  };
  minimise(cost, 2 * hats, relative_tolerance);
  return best;
}

}  // namespace floeplan::planning::refinement
