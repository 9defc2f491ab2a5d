#pragma once

#include <memory>
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
  double inverse_flattening{298.257223563};  // 0: a sphere
  friend bool operator==(Ellipsoid, Ellipsoid) = default;
};

inline constexpr Ellipsoid wgs84{};
/// GRS 1980, the ellipsoid of NAD83 and ETRS89. Places on it lie up to 0.1 mm beside those on WGS84.
/// Source  EPSG:7019
inline constexpr Ellipsoid grs_1980{6378137.0, 298.257222101};
/// Hughes 1980, the ellipsoid of satellite products of sea ice.
/// Source  EPSG:7058; axes 6378273 m and 6356889.449 m
inline constexpr Ellipsoid hughes_1980{6378273.0, 298.279411123064};

/// Polar stereographic projection with a scale on one parallel (EPSG methods 9829 and, with the pole as that
/// parallel, 9810). Examples: EPSG:3413, 3995, 3996, 3031 on WGS84; EPSG:3411, 3412 on Hughes 1980; UPS.
struct PolarStereographicFrame {
  bool north{true};
  double lat_ts_deg{90.0};  // positive in the north, negative in the south
  double lon_0_deg{};       // meridian that runs straight down (north) or up (south)
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  double scale_ts{1.0};
  friend bool operator==(PolarStereographicFrame, PolarStereographicFrame) = default;
};

/// Transverse Mercator projection (EPSG method 9807), for example every UTM zone.
struct TransverseMercatorFrame {
  double lon_0_deg{};
  double lat_0_deg{};
  double scale_0{0.9996};
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  friend bool operator==(TransverseMercatorFrame, TransverseMercatorFrame) = default;
};

/// Lambert's conformal conic projection with a scale on two parallels, or on one if they are equal (EPSG methods
/// 9801, 9802). If they are the equator, or as far north of it as south, it is the Mercator projection (9804,
/// 9805).
struct LambertConformalFrame {
  double lat_1_deg{};
  double lat_2_deg{};
  double scale_1{1.0};
  double lat_0_deg{};  // of the false origin
  double lon_0_deg{};
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  friend bool operator==(LambertConformalFrame, LambertConformalFrame) = default;
};

/// Albers' equal-area conic projection with two standard parallels (EPSG method 9822). If they are the equator, or
/// as far north of it as south, it is Lambert's cylindrical projection (9835); if both are one pole, his azimuthal
/// one around that pole.
struct AlbersFrame {
  double lat_1_deg{};
  double lat_2_deg{};
  double lat_0_deg{};  // of the false origin
  double lon_0_deg{};
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  friend bool operator==(AlbersFrame, AlbersFrame) = default;
};

/// Lambert's azimuthal equal-area projection around a place other than a pole (EPSG method 9820), for example
/// EPSG:3035.
struct AzimuthalEqualAreaFrame {
  double lat_0_deg{};
  double lon_0_deg{};
  double false_easting_m{};
  double false_northing_m{};
  Ellipsoid ellipsoid{};
  friend bool operator==(AzimuthalEqualAreaFrame, AzimuthalEqualAreaFrame) = default;
};

/// The coordinates in which a stored grid is regular. Grids in other projections are stored as meshes of points.
using GridFrame = std::variant<GeographicFrame, PolarStereographicFrame, TransverseMercatorFrame,
                               LambertConformalFrame, AlbersFrame, AzimuthalEqualAreaFrame>;

/// The map between places and points of a frame, with the constants of its formulas computed once.
/// Outside  a place that the projection does not show has a point that is not finite or farther from the origin
///          than the Earth is wide; a point that shows no place has a place that is not finite or that has
///          another point
/// Accuracy 1e-9 degrees, within 3900 km of the central meridian of a transverse Mercator projection
/// Threads  const members may be called from several threads at once
/// Source   Karney 2011 and 2023 (GeographicLib); azimuthal equal-area: Snyder 1987, pp. 187-190, with the place on
///          the authalic sphere as a vector
class FrameProjection {
 public:
  /// Errors  std::invalid_argument for parameters that no projection has
  explicit FrameProjection(const GridFrame& frame);

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  [[nodiscard]] GridPoint to_grid(LonLat place) const;
  [[nodiscard]] LonLat to_lon_lat(GridPoint point) const;
  /// The meridian at which a conic or cylindrical projection is cut open: places on its two sides have points far
  /// apart. Other projections: nullopt.
  [[nodiscard]] std::optional<double> cut_deg() const;

 private:
  struct Formula;

  GridFrame frame_;
  std::shared_ptr<const Formula> formula_;  // null: geographic
};

/// The frame as text with all digits, and back: "geographic", "polar_stereographic north 70 -45 0 0", ... An
/// ellipsoid other than WGS84 is added at the end: "... 0 0 6378273 298.279411123064", and after it the scale of a
/// polar stereographic projection that is not 1.
[[nodiscard]] std::string frame_text(const GridFrame& frame);
[[nodiscard]] std::optional<GridFrame> parse_frame(std::string_view text);

}  // namespace floeplan::geo
