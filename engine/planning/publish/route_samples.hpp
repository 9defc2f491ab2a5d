#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::publish {

/// Calls `visit(leg, share, point)` at both ends of every leg and between them: the leg that leads to this
/// point of the route, and the share of this leg that the vehicle has covered there. The start belongs to leg
/// 0.
template <class Visit>
void for_each_sample(const std::vector<geo::PlanePoint>& route, Visit&& visit) {
  constexpr double step_m = 250.0;  // about the cells of the finest bathymetry in use
  visit(std::size_t{0}, 0.0, route.front());
  for (std::size_t i = 1; i < route.size(); ++i) {
    const geo::PlanePoint a = route[i - 1];
    const geo::PlanePoint b = route[i];
    const int pieces = std::max(1, static_cast<int>(std::ceil(geo::distance_m(a, b) / step_m)));
    for (int piece = 1; piece <= pieces; ++piece) {
      const double share = static_cast<double>(piece) / pieces;
      visit(i, share, geo::PlanePoint{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
    }
  }
}

}  // namespace floeplan::planning::publish
