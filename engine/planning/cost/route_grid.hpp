#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/graph/grid_graph.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::cost {

/// How far a grid reaches beyond start and goal, as shares of their distance.
struct GridReach {
  double across{0.5};   // to either side of the straight line
  double beyond{0.25};  // behind the start and past the goal
  /// On every side, however short the distance: what a short way has to go round is no smaller than what a long one
  /// has.
  /// Of a fine grid no more than `most_steps_of_least` steps.
  core::Metres at_least{0.0};

  static constexpr double most_steps_of_least = 200.0;
};

/// A grid in the plane whose columns run along the straight line from start to goal, so that both are
/// vertices. Vertex (column, row) lies at origin + column * along + row * across.
struct RouteGrid {
  geo::PlanePoint origin;
  geo::PlanePoint along;   // from one column to the next
  geo::PlanePoint across;  // from one row to the next
  int nx{};
  int ny{};
  graph::Vertex start{};
  graph::Vertex goal{};

  [[nodiscard]] geo::PlanePoint point(graph::Vertex v) const {
    const auto width = static_cast<graph::Vertex>(nx);
    const graph::Vertex whole_rows = v / width;
    const auto column = static_cast<double>(v % width);
    const auto row = static_cast<double>(whole_rows);
    return {origin.x_m + column * along.x_m + row * across.x_m,
            origin.y_m + column * along.y_m + row * across.y_m};
  }
  [[nodiscard]] plane::PlaneBox bounds() const;
  /// Between neighbours in a row or a column, whichever are nearer to each other; metres of the plane.
  [[nodiscard]] core::Metres shortest_step() const;
  [[nodiscard]] double vertex_count() const { return static_cast<double>(nx) * ny; }
};

/// Grid steps of a request for a leg of this length: as asked for, or distance/200 within 250 m .. 5 km.
struct GridSpacing {
  core::Metres along;
  core::Metres across;
};

/// The step along is fitted so that the goal falls on a vertex. Where start and goal are one place, the grid lies round
/// it and its columns run along the x axis.
[[nodiscard]] RouteGrid lay_grid(geo::PlanePoint start, geo::PlanePoint goal, GridSpacing spacing,
                                 GridReach reach);

}  // namespace floeplan::planning::cost
