#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// Closed line; the last place joins the first and is not repeated. Neighbours are less than 180 degrees
/// apart.
using Ring = std::vector<LonLat>;

/// Area inside `outer` and outside every hole. Edges are straight in longitude and latitude, as charts draw
/// them.
/// Edges    a ring may cross the antimeridian (its longitudes jump there); it may not lead round a pole. An area round
///          a pole is cut along a meridian, down to the pole, round it and back
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  /// Memory of the corners.
  [[nodiscard]] std::size_t bytes() const;
};

[[nodiscard]] bool contains(const Polygon& polygon, LonLat place);
/// For each place, whether any of the polygons contains it. Many places in a coastline of many corners take little
/// longer than one.
[[nodiscard]] std::vector<bool> contained_in_any(std::span<const Polygon> polygons,
                                                 std::span<const LonLat> places);
/// The smallest box round the outline with all its edges; the whole circle where they lead all the way round.
[[nodiscard]] BoundingBox bounding_box(const Polygon& polygon);

}  // namespace floeplan::geo
