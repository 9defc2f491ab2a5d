#pragma once

#include <vector>

#include "engine/geo/local_projection.hpp"

namespace floeplan::reproduction {

/// A closed rectangle along the axes of the plane.
struct Obstacle {
  geo::PlanePoint low;
  geo::PlanePoint high;

  /// Whether the straight line from a to b meets or touches the obstacle. a may equal b.
  [[nodiscard]] bool meets(geo::PlanePoint a, geo::PlanePoint b) const;
};

/// Stationary obstacles in the jet. The paper gives neither number, shape nor place of its obstacles (Figure
/// 10). Ours close the same number of vertices of the 41 x 21 grid, 45. A random search for rectangles found
/// them: they leave nearly the paper's numbers of edges (5908, 11190 and 20516) and search times within 1.4
/// %. An obstacle closes an edge in both directions, so the paper's odd numbers 11195 and 20517 are
/// impossible. No edge touches a corner without crossing it, so the counts do not depend on rounding.
[[nodiscard]] const std::vector<Obstacle>& jet_obstacles();

}  // namespace floeplan::reproduction
