#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// A point in a grid's own coordinates: degrees (longitude, latitude) or metres (easting, northing).
struct GridPoint {
  double x{};
  double y{};
};

/// Longitude and latitude as coordinates.
struct GeographicFrame {
  friend bool operator==(GeographicFrame, GeographicFrame) = default;
};

/// The ellipsoid in a frame's formulas. Latitudes on it are taken as latitudes on WGS84.
struct Ellipsoid {
  double semi_major_m{6378137.0};
  double inverse_flattening{298.257223563};
  friend bool operator==(Ellipsoid, Ellipsoid) = default;
};

inline constexpr Ellipsoid wgs84{};
/// Hughes 1980, the ellipsoid of satellite products of sea ice.
/// Source  EPSG:7058; axes 6378273 m and 6356889.449 m
inline constexpr Ellipsoid hughes_1980{6378273.0, 298.279411123064};

/// Polar stereographic projection, true to scale on one parallel (EPSG method 9829). Examples: EPSG:3413,
/// 3995, 3996, 3031 on WGS84; EPSG:3411, 3412 on Hughes 1980.
struct PolarStereographicFrame {
  bool north{true};
  double lat_ts_deg{90.0};  // positive in the north, negative in the south
  double lon_0_deg{};       // meridian that runs straight down (north) or up (south)
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  friend bool operator==(PolarStereographicFrame, PolarStereographicFrame) = default;
};

/// Transverse Mercator projection on WGS84 (EPSG method 9807), for example every UTM zone.
struct TransverseMercatorFrame {
  double lon_0_deg{};
  double lat_0_deg{};
  double scale_0{0.9996};
  double false_easting_m{};
  double false_northing_m{};
  friend bool operator==(TransverseMercatorFrame, TransverseMercatorFrame) = default;
};

/// The coordinates in which a stored grid is regular. Grids in other projections are stored as meshes of points.
using GridFrame = std::variant<GeographicFrame, PolarStereographicFrame, TransverseMercatorFrame>;

[[nodiscard]] GridPoint to_grid(const GridFrame& frame, LonLat place);
[[nodiscard]] LonLat to_lon_lat(const GridFrame& frame, GridPoint point);

/// The frame as text with all digits, and back: "geographic", "polar_stereographic north 70 -45 0 0", ... An
/// ellipsoid other than WGS84 is added at the end: "... 0 0 6378273 298.279411123064".
[[nodiscard]] std::string frame_text(const GridFrame& frame);
[[nodiscard]] std::optional<GridFrame> parse_frame(std::string_view text);

}  // namespace floeplan::geo
