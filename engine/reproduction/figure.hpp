#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/motion/plane_current.hpp"
#include "engine/reproduction/obstacle.hpp"

namespace floeplan::reproduction {

/// A path in a figure, in the plane's own units.
struct FigurePath {
  std::string name;      // "1-sector", "optimal control", ...
  double travel_time{};  // of the whole path, in the figure's unit of time
  std::string colour;    // as SVG has it
  bool dashed{false};
  std::vector<geo::PlanePoint> points;
};

struct FigureArrow {
  geo::PlanePoint at;
  motion::CurrentXy current;
};

/// One drawing of a figure: the water at a time and what lies in it.
struct FigurePanel {
  std::string title;  // empty: the figure has one panel
  std::vector<FigureArrow> arrows;
  std::vector<Obstacle> obstacles;
  std::vector<FigurePath> paths;
  std::optional<geo::PlanePoint> vehicle;  // where it is at that time
};

/// Axis from one end to the other with a tick at every `step`, drawn so many pixels long.
struct FigureAxis {
  std::string label;
  double low{};
  double high{};
  double step{};
  double pixels{};
};

/// What a figure of the paper shows, before it is drawn.
struct Figure {
  int number{};
  std::string title;
  FigureAxis x;
  FigureAxis y;
  geo::PlanePoint start;
  geo::PlanePoint goal;
  double unit_m{};            // metres that one unit of the plane stands for on a map
  std::string time_unit;      // empty: without dimension
  std::string speed_unit;     // likewise
  double pixels_per_speed{};  // length of an arrow
  int panels_in_a_row{1};
  std::vector<FigurePanel> panels;
};

inline constexpr int first_figure = 5;
inline constexpr int last_figure = 10;

/// Figures 5 to 10 of the paper from our own searches. Those of the jet show the stand-in of `jet_cases`, the
/// last one the obstacles of `jet_obstacles`.
/// Source   Eichhorn 2009, Figures 5 to 10
[[nodiscard]] std::vector<Figure> reproduce_figures();

/// The figure as an SVG 1.1 document: axes with ticks and labels, arrows of the current with their scale,
/// obstacles, paths, start and goal, and a legend with the travel times.
[[nodiscard]] std::string figure_svg(const Figure& figure);

}  // namespace floeplan::reproduction
