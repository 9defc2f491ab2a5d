#pragma once

#include <algorithm>
#include <utility>

#include "engine/planning/refinement/hat_basis.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Coordinate descent: shifts groups of points (the hats of `HatBasis`) one after another, across and along
/// the route, if the cost falls, with steps from coarse to fine. It needs no derivative. It can slide along
/// the edge of closed areas, where a descent of all points at once stops as soon as one point touches. The
/// number of legs stays.
template <cost::CostedLeg Leg>
class CoordinateDescent {
 public:
  CoordinateDescent(LegMeter<Leg>& legs, cost::Itinerary start)
      : legs_{legs}, best_{std::move(start)}, basis_{best_} {}

  /// One round over all step sizes and all hats.
  cost::Itinerary operator()() {
    // Step sizes, as shares of half the width of a hat.
    constexpr double coarsest = 0.2;
    constexpr double finest = 0.002;
    for (double share = coarsest; share > finest; share *= 0.4) {
      for (const HatBasis::Hat& hat : basis_.hats()) move(hat, share);
    }
    return best_;
  }

 private:
  void move(const HatBasis::Hat& hat, double share) {
    const geo::PlanePoint a = best_.route.points[hat.left];
    const geo::PlanePoint b = best_.route.points[hat.right];
    const double x_m = 0.5 * share * (b.x_m - a.x_m);
    const double y_m = 0.5 * share * (b.y_m - a.y_m);
    constexpr int most_repeats = 10;
    for (const auto& [dx_m, dy_m] : {std::pair{-y_m, x_m}, {y_m, -x_m}, {x_m, y_m}, {-x_m, -y_m}}) {
      for (int i = 0; i < most_repeats && try_shift(hat, dx_m, dy_m); ++i) {
      }
    }
  }

  /// Shifts the points of a hat if that lowers the cost of the route. Returns whether it does.
  bool try_shift(const HatBasis::Hat& hat, double dx_m, double dy_m) {
    const std::vector<geo::PlanePoint>& points = best_.route.points;
    std::vector<geo::PlanePoint> moved;
    std::vector<core::Seconds> times;
    std::vector<double> costs;
    geo::PlanePoint from = points[hat.left];
    core::Seconds now = best_.times[hat.left];
    double cost = best_.costs[hat.left];
    for (std::size_t i = hat.left + 1; i < points.size(); ++i) {
      geo::PlanePoint to = points[i];
      if (i < hat.right) {
        const double height =
            i <= hat.peak ? share_between(hat.left, hat.peak, i) : share_between(hat.right, hat.peak, i);
        to.x_m += height * dx_m;
        to.y_m += height * dy_m;
      }
      const auto leg = legs_(from, to, now);
      if (!leg) return false;
      now += leg->time;
      cost += leg->cost;
      moved.push_back(to);
      times.push_back(now);
      costs.push_back(cost);
      // A route that is no earlier and no cheaper here will hardly become better later.
      if (i >= hat.right && !(now < best_.times[i] || cost < best_.costs[i])) return false;
      from = to;
    }
    if (!(cost < best_.cost())) return false;
    const auto first = static_cast<std::ptrdiff_t>(hat.left) + 1;
    std::ranges::copy(moved, best_.route.points.begin() + first);
    std::ranges::copy(times, best_.times.begin() + first);
    std::ranges::copy(costs, best_.costs.begin() + first);
    return true;
  }

  static double share_between(std::size_t zero, std::size_t one, std::size_t i) {
    return (static_cast<double>(i) - static_cast<double>(zero)) /
           (static_cast<double>(one) - static_cast<double>(zero));
  }

  LegMeter<Leg>& legs_;
  cost::Itinerary best_;
  HatBasis basis_;
};

}  // namespace floeplan::planning::refinement
