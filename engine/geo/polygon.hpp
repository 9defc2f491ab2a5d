#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A closed line. The last place is joined to the first, which is not repeated. Consecutive places are less
/// than 180 degrees apart.
using Ring = std::vector<LonLat>;

/// The area inside `outer` and outside every hole. Edges are straight in longitude and latitude, as on
/// charts.
/// Edges    A ring may cross the antimeridian, where its longitudes jump. It must not lead around a pole: an
///          area around a pole is cut along a meridian to the pole, along the pole's parallel and back
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  /// Memory of the corners in bytes.
  [[nodiscard]] std::size_t bytes() const;
};

[[nodiscard]] bool contains(const Polygon& polygon, LonLat place);
/// For each place, whether any of the polygons contains it. For a coastline with many corners, many places
/// take little longer than one.
[[nodiscard]] std::vector<bool> contained_in_any(std::span<const Polygon> polygons,
                                                 std::span<const LonLat> places);
/// The smallest box around the outline with its edges; all longitudes if these lead all the way round.
[[nodiscard]] BoundingBox bounding_box(const Polygon& polygon);

}  // namespace floeplan::geo
