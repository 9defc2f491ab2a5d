#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/graph/grid_graph.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::cost {

/// How far a grid extends beyond start and goal, as shares of the distance between them.
struct GridReach {
  double across{0.5};   // on each side of the straight line
  double beyond{0.25};  // behind the start and past the goal
  /// Least extent on every side: obstacles on a short route are as large as on a long one. To keep the grid
  /// small, this rule adds at most `most_steps_of_least` steps.
  core::Metres at_least{0.0};

  static constexpr double most_steps_of_least = 200.0;
};

/// A grid in the plane. Its columns run along the straight line from start to goal, so both are vertices. Vertex
/// (column, row) lies at origin + column * along + row * across.
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
  /// The smaller of the two spacings, between columns or between rows; metres of the plane.
  [[nodiscard]] core::Metres shortest_step() const;
  [[nodiscard]] double vertex_count() const { return static_cast<double>(nx) * ny; }
};

/// Grid steps for a leg: along the line from start to goal, and across it.
struct GridSpacing {
  core::Metres along;
  core::Metres across;
};

/// Makes the grid between two points of the plane. The step along the line is adjusted so that the goal is a
/// vertex. If start and goal are the same place, the grid lies around it and its columns run along the x
/// axis.
[[nodiscard]] RouteGrid lay_grid(geo::PlanePoint start, geo::PlanePoint goal, GridSpacing spacing,
                                 GridReach reach);

}  // namespace floeplan::planning::cost
