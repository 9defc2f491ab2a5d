#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "engine/planning/leg_meter.hpp"

namespace floeplan::planning {

/// Derivatives of the arrival by every point's coordinates, in seconds for each metre.
struct ArrivalGradient {
  std::vector<double> x;
  std::vector<double> y;
};

/// A change of a leg's time with one of its arguments, over `step` to both sides, or to the side that is
/// open; zero between closed sides.
inline double derivative(core::Seconds here, std::optional<core::Seconds> above,
                         std::optional<core::Seconds> below, double step) {
  if (above && below) return (*above - *below).count() / (2.0 * step);
  if (above) return (*above - here).count() / step;
  if (below) return (here - *below).count() / step;
  return 0.0;
}

/// By the chain rule from the goal back to the start: a leg's time changes the arrival by as much as a later
/// departure from its end does. Eleven evaluations for each leg.
template <LegTime Timer>
ArrivalGradient arrival_gradient(LegMeter<Timer>& legs, const Itinerary& timed) {
  // Of a leg: small beside the scale on which a current changes, large beside the integration's error.
  constexpr double step_share = 1e-3;
  const auto& points = timed.route.points;
  ArrivalGradient gradient{std::vector<double>(points.size()), std::vector<double>(points.size())};
  double by_departure = 1.0;  // derivative of the arrival at the goal by the time at the leg's end
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    const geo::PlanePoint a = points[i - 1];
    const geo::PlanePoint b = points[i];
    const core::Seconds depart = timed.times[i - 1];
    const core::Seconds time = timed.times[i] - depart;
    const double h = step_share * geo::distance_m(a, b);
    if (h <= 0.0) continue;
    const auto along = [&](auto&& leg) { return derivative(time, leg(h), leg(-h), h); };

    gradient.x[i - 1] += by_departure * along([&](double d) { return legs({a.x_m + d, a.y_m}, b, depart); });
    gradient.y[i - 1] += by_departure * along([&](double d) { return legs({a.x_m, a.y_m + d}, b, depart); });
    gradient.x[i] += by_departure * along([&](double d) { return legs(a, {b.x_m + d, b.y_m}, depart); });
    gradient.y[i] += by_departure * along([&](double d) { return legs(a, {b.x_m, b.y_m + d}, depart); });
    const core::Seconds later = step_share * time;
    by_departure *=
        1.0 + derivative(time, legs(a, b, depart + later), legs(a, b, depart - later), later.count());
  }
  return gradient;
}

}  // namespace floeplan::planning
