#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/motion/plane_current.hpp"
#include "engine/reproduction/obstacle.hpp"

namespace floeplan::reproduction {

/// A path in a figure, in the plane's own units.
struct FigurePath {
  std::string name;      // such as "1-sector" or "optimal control"
  double travel_time{};  // of the whole path, in the figure's unit of time
  std::string colour;    // as in SVG
  bool dashed{false};
  std::vector<geo::PlanePoint> points;
};

struct FigureArrow {
  geo::PlanePoint at;
  motion::CurrentXy current;
};

/// One panel of a figure: the current at a time, and the paths and obstacles in it.
struct FigurePanel {
  std::string title;  // empty if the figure has only one panel
  std::vector<FigureArrow> arrows;
  std::vector<Obstacle> obstacles;
  std::vector<FigurePath> paths;
  std::optional<geo::PlanePoint> vehicle;  // place at that time
};

/// An axis with a tick at every `step`, and its length in pixels.
struct FigureAxis {
  std::string label;
  double low{};
  double high{};
  double step{};
  double pixels{};
};

/// The contents of one of the paper's figures, before drawing.
struct Figure {
  int number{};
  std::string title;
  FigureAxis x;
  FigureAxis y;
  geo::PlanePoint start;
  geo::PlanePoint goal;
  double unit_m{};            // metres per unit of the plane, for a map
  std::string time_unit;      // empty: dimensionless
  std::string speed_unit;     // empty: dimensionless
  double pixels_per_speed{};  // length of an arrow
  int panels_in_a_row{1};
  std::vector<FigurePanel> panels;
};

inline constexpr int first_figure = 5;
inline constexpr int last_figure = 10;

/// Figures 5 to 10 of the paper, computed by our own searches. The figures of the jet use the assumed extents
/// of `jet_cases`, the last one the assumed obstacles of `jet_obstacles`.
/// Source   Eichhorn 2009, Figures 5 to 10
[[nodiscard]] std::vector<Figure> reproduce_figures();

/// The figure as an SVG 1.1 document: axes with ticks and labels, arrows of the current with their scale,
/// obstacles, paths, start and goal, and a legend with the travel times.
[[nodiscard]] std::string figure_svg(const Figure& figure);

}  // namespace floeplan::reproduction
