#pragma once

#include <vector>

#include "engine/graph/corridors.hpp"
#include "engine/planning/currents/analytic_currents.hpp"
#include "engine/planning/optimal_control/optimal_control.hpp"

namespace floeplan::planning {

/// The crossings of the paper's Tables II and III; the second is our stand-in.
inline const optimal_control::Crossing over_the_river{{0.0, 30.0}, {300.0, 30.0}, core::Seconds{0.0}, {2.2}};
inline const optimal_control::Crossing along_the_jet{{-8.0, -2.0}, {10.0, 1.0}, core::Seconds{0.0}, {0.5}};

/// Ways of the stand-in's 3-sector grid through the jet, in different corridors.
inline std::vector<std::vector<geo::PlanePoint>> ways_along_the_jet(std::size_t most) {
  const graph::GridGraph grid{41, 21, 3};
  const currents::MeanderingJet jet;
  const optimal_control::LegTimer leg_timer = optimal_control::legs_in(jet, along_the_jet.through_water);
  const auto point = [&](graph::Vertex v) {
    return geo::PlanePoint{-10.0 + 0.5 * grid.column(v), -5.0 + 0.5 * grid.row(v)};
  };
  const auto travel_time = [&](const graph::Edge& edge, core::Seconds depart, core::Seconds) {
    return leg_timer(point(edge.tail), point(edge.head), depart);
  };
  const graph::Query query{grid.vertex(4, 6), grid.vertex(40, 12), along_the_jet.depart};
  std::vector<std::vector<geo::PlanePoint>> ways;
  for (const auto& path : graph::find_corridors(grid, query, travel_time, most)) {
    ways.emplace_back();
    for (const graph::Vertex v : path) ways.back().push_back(point(v));
  }
  return ways;
}

}  // namespace floeplan::planning
