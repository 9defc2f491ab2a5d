#pragma once

#include <utility>

#include "engine/planning/arrival_gradient.hpp"
#include "engine/planning/hat_basis.hpp"
#include "engine/planning/minimiser.hpp"

namespace floeplan::planning {

/// What a descent reached.
struct SmoothMoves {
  Itinerary itinerary;     // never later than where it started
  bool met_closed{false};  // tried a route with a closed leg: closures may stand in its way
};

/// Moves all free points at once, down the gradient of the arrival. The number of legs stays.
template <LegTime Timer>
SmoothMoves descend_smoothly(LegMeter<Timer>& legs, Itinerary start, double relative_tolerance) {
  const Route& from = start.route;
  const HatBasis basis{start};
  const std::size_t hats = basis.hats().size();
  SmoothMoves best{start, false};
  if (hats == 0 || !(start.travel_time().count() > 0.0)) return best;

  const auto arrival = [&](std::span<const double> x, std::span<double> gradient) -> std::optional<double> {
    const std::vector<double> shift_x = basis.shifts(x.first(hats));
    const std::vector<double> shift_y = basis.shifts(x.last(hats));
    Route moved = from;
    for (std::size_t i = 0; i < moved.points.size(); ++i) {
      moved.points[i].x_m += shift_x[i];
      moved.points[i].y_m += shift_y[i];
    }
    auto timed = legs.timed(std::move(moved), start.times.front());
    if (!timed) {
      best.met_closed = true;
      return std::nullopt;
    }
    ArrivalGradient by_shift = arrival_gradient(legs, *timed);
    basis.derive(std::move(by_shift.x), gradient.first(hats));
    basis.derive(std::move(by_shift.y), gradient.last(hats));
    const double travel_time = timed->travel_time().count();
    if (timed->arrival() < best.itinerary.arrival()) best.itinerary = std::move(*timed);
    return travel_time;
  };
  minimise(arrival, 2 * hats, relative_tolerance);
  return best;
}

}  // namespace floeplan::planning
