#pragma once

#include <optional>
#include <vector>

#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Derivatives of the total cost with respect to the coordinates of every point, per metre.
struct CostGradient {
  std::vector<double> x;
  std::vector<double> y;
};

/// Derivatives of the time and cost of a leg with respect to one of its arguments.
struct LegDerivative {
  double of_time{};
  double of_cost{};
};

/// Difference quotient over `step` on both sides, or on the side that is open; zero if both are closed.
inline LegDerivative derivative(const cost::LegCost& here, const std::optional<cost::LegCost>& above,
                                const std::optional<cost::LegCost>& below, double step) {
  if (!above && !below) return {};
  const cost::LegCost upper = above.value_or(here);
  const cost::LegCost lower = below.value_or(here);
  const double over = above && below ? 2.0 * step : step;
  return {(upper.time - lower.time).count() / over, (upper.cost - lower.cost) / over};
}

/// Applies the chain rule from the goal back to the start: a longer leg changes the cost after it like a
/// later departure from its end. Needs eleven evaluations per leg.
template <cost::CostedLeg Leg>
CostGradient cost_gradient(LegMeter<Leg>& legs, const cost::Itinerary& timed) {
  // Share of a leg: small compared with the scale on which a current changes, large compared with integration
  // errors.
  constexpr double step_share = 1e-3;
  const auto& points = timed.route.points;
  CostGradient gradient{std::vector<double>(points.size()), std::vector<double>(points.size())};
  double by_departure = 0.0;  // derivative of the cost after the leg with respect to the time at its end
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    const geo::PlanePoint a = points[i - 1];
    const geo::PlanePoint b = points[i];
    const core::Seconds depart = timed.times[i - 1];
    const cost::LegCost here{timed.times[i] - depart, timed.costs[i] - timed.costs[i - 1]};
    const double h = step_share * geo::distance_m(a, b);
    if (h <= 0.0) continue;
    const auto along = [&](auto&& leg) {
      const LegDerivative change = derivative(here, leg(h), leg(-h), h);
      return change.of_cost + by_departure * change.of_time;
    };

    gradient.x[i - 1] += along([&](double d) { return legs({a.x_m + d, a.y_m}, b, depart); });
    gradient.y[i - 1] += along([&](double d) { return legs({a.x_m, a.y_m + d}, b, depart); });
    gradient.x[i] += along([&](double d) { return legs(a, {b.x_m + d, b.y_m}, depart); });
    gradient.y[i] += along([&](double d) { return legs(a, {b.x_m, b.y_m + d}, depart); });
    const core::Seconds later = step_share * here.time;
    const LegDerivative change =
        derivative(here, legs(a, b, depart + later), legs(a, b, depart - later), later.count());
    by_departure = change.of_cost + by_departure * (1.0 + change.of_time);
  }
  return gradient;
}

}  // namespace floeplan::planning::refinement
