#pragma once

#include <functional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::routes {

/// The shape that a query of OGC API - EDR asks for.
struct EdrArea {
  geo::BoundingBox box;
  /// Whether the place lies in the shape, on its edge, or no further than the tolerance (degrees of latitude) outside.
  std::function<bool(geo::LonLat, double)> covers;
  std::vector<geo::LonLat> middles;  // well inside each part of the shape; empty: it encloses no area
  /// Whether a grid that is asked for with so many places a side begins and ends on the edges of the box, as the
  /// standard has it for cubes; else each place is the middle of its share of the box.
  bool places_on_edges{false};
};

[[nodiscard]] EdrArea area_of_box(const geo::BoundingBox& box);
[[nodiscard]] EdrArea area_of_disc(geo::LonLat centre, core::Metres radius);
[[nodiscard]] EdrArea area_of_polygons(std::vector<geo::Polygon> polygons);

}  // namespace floeplan::routes
