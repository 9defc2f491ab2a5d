#pragma once

#include <functional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::routes {

/// The shape of an OGC API - EDR query.
struct EdrArea {
  geo::BoundingBox box;
  /// Whether a place is in the shape, on its edge, or outside by at most the tolerance, in degrees of
  /// latitude.
  std::function<bool(geo::LonLat, double)> covers;
  std::vector<geo::LonLat> middles;  // a position inside each part of the shape; empty: the shape has no area
  /// True: with a requested number of places per side, the first and last lie on the edges of the box, as the
  /// standard requires for cubes. False: each place is the middle of its share of the box.
  bool places_on_edges{false};
};

[[nodiscard]] EdrArea area_of_box(const geo::BoundingBox& box);
[[nodiscard]] EdrArea area_of_disc(geo::LonLat centre, core::Metres radius);
[[nodiscard]] EdrArea area_of_polygons(std::vector<geo::Polygon> polygons);

}  // namespace floeplan::routes
