#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::codec {

/// A position in a well-known text, with its depth and time if the text has them.
struct WktPlace {
  geo::LonLat place;
  std::optional<double> z_m;
  std::optional<core::UtcTime> time;  // the measure M, seconds since 1970
};

enum class WktKind { point, multi_point, line, polygon };

/// Coordinates of an EDR query. For polygons only `areas` is set, otherwise only `places`.
struct WktGeometry {
  WktKind kind{WktKind::point};
  std::vector<WktPlace> places;
  std::vector<geo::Polygon> areas;
  bool has_z{false};  // the text has Z values; those of polygons are not kept
};

/// Reads POINT, MULTIPOINT, LINESTRING, POLYGON and MULTIPOLYGON, plain or with Z, M or ZM ("POINT Z (...)" or
/// "POINTZ(...)"), longitude first, at most 10,000 places.
/// Edges    an edge of a ring takes the shorter way around the globe; an edge from -180 to 180 goes all the
///          way around
/// Empty    for any other text, also for EMPTY and for positions that are not on the Earth
/// Source   OGC 06-103r4, 7.2
[[nodiscard]] std::optional<WktGeometry> parse_wkt(std::string_view text);

}  // namespace floeplan::codec
