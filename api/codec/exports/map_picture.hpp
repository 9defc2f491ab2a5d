#pragma once

#include <string>
#include <vector>

#include "api/codec/exports/svg_parts.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// A small map of a plan in picture units, y downwards, ready for any way of drawing lines and words.
struct MapPicture {
  using Point = PicturePoint;
  using Label = PictureLabel;
  struct Disc {
    Point centre;
    double radius{};
  };
  double width{};
  double height{};
  std::vector<std::vector<Point>> land;  // closed outlines; parts beyond the frame are cut off by the drawing
  std::vector<std::vector<Point>> grid;  // meridians and parallels
  std::vector<Label> grid_labels;
  std::vector<Disc> icebergs;  // of their length, at least two units
  std::vector<Point> route;
  std::vector<std::vector<Point>>
      below_ice;  // stretches of the route with sea ice or icebergs above them; of older plans whole legs
  std::vector<Point> closed;                // waypoints where the vehicle may not surface
  std::vector<std::vector<Point>> escapes;  // from waypoints to where it may
  std::vector<Point> surfacings;            // planned ones
  std::vector<Label> waypoints;
  std::vector<Point> scale;  // a line as long as `scale_label` says
  std::string scale_label;
};

/// Draws the surroundings of a route: distances are true along its middle parallel.
/// `land`, `icebergs`  of the surroundings; what lies far outside costs nothing
/// Errors   std::invalid_argument for a plan without waypoints or a picture without room
[[nodiscard]] MapPicture draw_map(const planning::Plan& plan, const std::vector<geo::Polygon>& land,
                                  const std::vector<ocean::Iceberg>& icebergs, double width, double height);

/// Radius of the mark of a planned surfacing, in picture units.
inline constexpr double surfacing_radius = 4.0;

/// Side of the square that marks a waypoint where the vehicle may not surface, in picture units.
inline constexpr double closed_side = 7.0;

/// The picture as an SVG element, to be put into a page. The same picture gives the same bytes.
[[nodiscard]] std::string svg(const MapPicture& picture);

}  // namespace floeplan::codec
