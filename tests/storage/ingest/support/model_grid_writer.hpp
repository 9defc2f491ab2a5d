#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/geo/grid_frame.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ingest {

/// A current that is known everywhere, also at the antimeridian and the poles: that of an Earth covered with
/// water that rotates about an axis through `lon`, `lat`. Its greatest speed is 0.5 m/s.
[[nodiscard]] geo::VelocityEn turning_sea(geo::LonLat place);

/// A curvilinear grid: a plane with its origin at a place, rotated by an angle. Indices (i, j) may be
/// half-integers.
struct ModelGrid {
  geo::LonLat origin{15.0, 70.0};
  double turned_deg{40.0};  // of the first axis, counterclockwise from east at the origin
  double spacing_m{20000.0};
  std::size_t columns{40};  // of centres
  std::size_t rows{30};
  /// A cap with two poles at 60 N on the meridian of the origin and opposite, like ORCA's north: rows are
  /// ellipses around both; the last but one is the fold between them, the last one is beyond it; the last two
  /// columns repeat the first two.
  bool two_poles{false};

  [[nodiscard]] geo::LonLat place(double i, double j) const;
  /// Angle of the first axis at a point, radians counterclockwise from east.
  [[nodiscard]] double angle(double i, double j) const;
  /// Component of the current along the first or the second axis there.
  [[nodiscard]] double first(double i, double j) const;
  [[nodiscard]] double second(double i, double j) const;
};

/// Two files, one of each component on points half a cell after the centres, as NEMO writes them. Land is zero.
void write_nemo(const ModelGrid& grid, const std::filesystem::path& u_file,
                const std::filesystem::path& v_file,
                const std::function<bool(std::size_t, std::size_t)>& is_land);

/// One file with both components on the points of a B grid, as POP writes them.
void write_pop(const ModelGrid& grid, const std::filesystem::path& file);

/// Variants of a ROMS file.
struct RomsOptions {
  int transform{2};
  bool with_positions_of_components{true};
  bool with_angle{true};
  double angle_error_deg{0.0};
  double shear_per_m{0.0};    // decrease of the current per metre of depth, as a share
  std::size_t wall_after{0};  // a wall between this column of centres and the next one ...
  std::size_t wall_rows{
      0};  // ... of so many rows; it is masked, and the file has a current there all the same
};

/// Writes a file on a C grid whose levels follow a sloping bed (100 m at the first column, 5 m deeper with
/// each), with a surface 1 m above the mean.
void write_roms(const ModelGrid& grid, const std::filesystem::path& file, const RomsOptions& options);

/// One file of a mesh of triangles with currents in its faces, as FVCOM writes them: two sigma layers over a bed of
/// 40 m; the lower one has half the current of the upper.
void write_fvcom(const ModelGrid& grid, const std::filesystem::path& file);

/// Variants of a file on a polar stereographic plane.
struct PolarOptions {
  bool along_axes{true};
  bool as_topaz{false};  // coordinates in units of 100 km, a sphere, tables of longitude and latitude
};

/// One file on a polar stereographic plane (EPSG:3413, rows from north to south).
void write_polar_plane(const std::filesystem::path& file, const PolarOptions& options);

}  // namespace floeplan::ingest
