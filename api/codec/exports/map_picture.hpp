#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/ice_marks.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The sea ice of a map and the vehicle's rule for it.
struct SeaIce {
  std::function<std::optional<double>(geo::LonLat)> concentration{};  // 0 to 1; empty: unknown
  double limit{};  // the largest concentration in which the vehicle may surface
};

/// A small map of a plan in picture units, y downwards, independent of the drawing library.
struct MapPicture {
  using Point = PicturePoint;
  using Label = PictureLabel;
  struct Disc {
    Point centre;
    double radius{};
  };
  double width{};
  double height{};
  struct Ice {
    IceMarks marks;
    double limit{};  // the largest concentration in which the vehicle may surface
    core::UtcTime time;
  };
  std::optional<Ice> ice{};              // at the departure; empty: the plan knows none
  std::vector<std::vector<Point>> land;  // closed outlines; the drawing must clip parts outside the frame
  std::vector<std::vector<Point>> grid;  // meridians and parallels
  std::vector<Label> grid_labels;
  std::vector<Disc> icebergs;  // radius by the berg's length, at least four units
  std::vector<Point> route;
  std::vector<std::vector<Point>>
      below_ice;  // stretches of the route with sea ice or icebergs above them; of older plans whole legs
  std::vector<Point> closed;                // waypoints where the vehicle may not surface
  std::vector<std::vector<Point>> escapes;  // from waypoints to where it may
  std::vector<Point> surfacings;            // planned ones
  std::vector<Label> waypoints;
  std::vector<Point> scale;  // line with the length stated in `scale_label`
  std::string scale_label;
};

/// The area that a map of the plan in this size shows.
[[nodiscard]] geo::BoundingBox map_area(const planning::Plan& plan, double width, double height);

/// Draws a route and its surroundings. Distances are true along the middle parallel. `land`, `icebergs` may
/// contain objects far outside; they are cheap. `ice` is the sea ice at the departure
/// Errors   std::invalid_argument for a plan without waypoints or a picture that is too small
[[nodiscard]] MapPicture draw_map(const planning::Plan& plan, const std::vector<geo::Polygon>& land,
                                  const std::vector<ocean::Iceberg>& icebergs, double width, double height,
                                  const std::optional<SeaIce>& ice = {});

/// Radius of the disc that marks a planned surfacing, in picture units. It has an arrow, as on the map of the browser,
/// and is dark: icebergs are light discs, also for a printer without colour.
inline constexpr double surfacing_radius = 6.0;
/// The lines of the arrow.
[[nodiscard]] std::vector<std::vector<PicturePoint>> surfacing_arrow(PicturePoint centre);

/// Side of the square that marks a waypoint where the vehicle may not surface, in picture units.
inline constexpr double closed_side = 7.0;

/// The picture as an SVG element, to be put into a page. The same picture gives the same bytes.
[[nodiscard]] std::string svg(const MapPicture& picture);

}  // namespace floeplan::codec
