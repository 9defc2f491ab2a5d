#pragma once

#include <vector>

#include "engine/geo/local_projection.hpp"

namespace floeplan::reproduction {

/// A closed rectangle along the axes of the plane.
struct Obstacle {
  geo::PlanePoint low;
  geo::PlanePoint high;

  /// Whether the straight line from a to b meets it; touching counts. a may equal b.
  [[nodiscard]] bool meets(geo::PlanePoint a, geo::PlanePoint b) const;
};

/// Stationary obstacles in the jet. The paper prints neither number, shape nor place of its own (Figure 10).
/// These close as many vertices of the 41 x 21 grid as the paper's, 45, and were found by a random search for
/// rectangles that leave about as many edges, 5908, 11190 and 20516, and let the searches take about as long,
/// within 1.4 %. An obstacle closes an edge in both its directions: the paper's 11195 and 20517, which are
/// odd, cannot be met. No edge touches a corner without crossing it: the counts do not hang on rounding.
[[nodiscard]] const std::vector<Obstacle>& jet_obstacles();

}  // namespace floeplan::reproduction
