#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::codec {

/// A place of a well-known text with what the text says of it beyond longitude and latitude.
struct WktPlace {
  geo::LonLat place;
  std::optional<double> z_m;
  std::optional<core::UtcTime> time;  // the measure M, seconds since 1970
};

enum class WktKind { point, multi_point, line, polygon };

/// Coordinates of an EDR query. Of polygons only the areas are set, of everything else only the places.
struct WktGeometry {
  WktKind kind{WktKind::point};
  std::vector<WktPlace> places;
  std::vector<geo::Polygon> areas;
  bool has_z{false};  // the text states Z, that of polygons without being kept
};

/// Reads POINT, MULTIPOINT, LINESTRING, POLYGON and MULTIPOLYGON, plain or with Z, M or ZM ("POINT Z (...)" or
/// "POINTZ(...)"), longitude first, at most 10,000 places.
/// Edges    of rings lead the short way round the globe; one from -180 to 180 leads all the way round
/// Empty    for anything else, also for EMPTY and for places that are none
/// Source   OGC 06-103r4, 7.2
[[nodiscard]] std::optional<WktGeometry> parse_wkt(std::string_view text);

}  // namespace floeplan::codec
