#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/geo/polygon.hpp"
#include "storage/demo/bathymetry_file.hpp"
#include "storage/demo/current_file.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/flat_earth.hpp"
#include "storage/demo/geojson_files.hpp"
#include "storage/demo/land_mask.hpp"
#include "storage/demo/scenarios.hpp"
#include "storage/demo/smooth_noise.hpp"
#include "storage/demo/tidal_flow.hpp"

namespace floeplan::demo {
namespace {

constexpr geo::LonLat middle_of_narrows{-58.5, 64.2};
constexpr FlatEarth strait_earth{64.2};
constexpr geo::BoundingBox strait_area{-59.1, 64.03, -57.9, 64.37};  // 58 km by 38 km
constexpr RasterFrame strait_relief_frame{
    strait_area.west_deg, strait_area.south_deg, 0.005, 0.0025, 240, 136};
// size of a square cell in metres, between a cell's true width and height
constexpr double relief_cell_m = 260.0;
constexpr RasterFrame strait_current_frame{
    strait_area.west_deg - 0.005, strait_area.south_deg - 0.0025, 0.01, 0.005, 121, 69};

constexpr double half_narrows_m = 2'500.0;
constexpr double half_length_of_narrows_m = 3'000.0;
constexpr double half_basin_m = 13'000.0;  // half the width where the shores are widest apart
constexpr double opening_out_m = 9'000.0;  // length over which the strait widens
constexpr double bends_m = 250.0;          // largest shift of a shore by its bends, to either side
constexpr double deepest_m = 130.0;
constexpr double strongest_tide_m_s = 0.52;  // one and a half times a glider's 0.35 m/s
// after the start: when the tide towards the east is strongest
constexpr double highest_tide_s = 2.0 * 3600.0;
constexpr std::array strait_depths_m{0.0, 30.0, 60.0, 90.0, 120.0, 150.0};
constexpr int strait_hours = 144;

geo::LonLat place_of(double x_m, double y_m) {
  return {middle_of_narrows.lon_deg + x_m / strait_earth.metres_per_degree_lon(),
          middle_of_narrows.lat_deg + y_m / metres_per_degree_lat};
}

/// Distance of each shore from the axis of the strait, before the bends are added.
double half_strait_m(double x_m) {
  const double beyond = std::max(0.0, std::abs(x_m) - half_length_of_narrows_m) / opening_out_m;
  return half_basin_m - (half_basin_m - half_narrows_m) * std::exp(-beyond * beyond);
}

/// Land from a shore to beyond the area's edge; `side` is 1 for the northern shore and -1 for the southern one.
geo::Polygon shore(double side, const SmoothNoise& bends) {
  constexpr double step_m = 250.0;
  constexpr double ends_m = 35'000.0;
  constexpr double inland_m = 22'000.0;
  geo::Polygon land;
  for (double x_m = -ends_m; x_m <= ends_m; x_m += step_m) {
    const double bend_m = bends_m * bends.at(x_m / 6'000.0, 50.0 * side);
    land.outer.push_back(place_of(x_m, side * (half_strait_m(x_m) + bend_m)));
  }
  land.outer.push_back(place_of(ends_m, side * inland_m));
  land.outer.push_back(place_of(-ends_m, side * inland_m));
  return land;
}

Relief strait_relief(const std::vector<geo::Polygon>& land, std::uint64_t seed) {
  Relief relief{strait_relief_frame, std::vector<float>(strait_relief_frame.size()),
                land_mask(strait_relief_frame, land)};
  const std::vector<float> to_land = cells_to(strait_relief_frame, relief.land, 1);
  const std::vector<float> to_sea = cells_to(strait_relief_frame, relief.land, 0);
  const SmoothNoise roughness{seed + 1, 4};
  for (std::size_t i = 0; i < strait_relief_frame.size(); ++i) {
    const std::size_t row = i / strait_relief_frame.columns;
    const std::size_t column = i % strait_relief_frame.columns;
    const double rough = roughness.at(0.04 * static_cast<double>(column), 0.04 * static_cast<double>(row));
    const auto inland_m = [&](float cells) { return (static_cast<double>(cells) - 0.5) * relief_cell_m; };
    const double metres =
        relief.land[i] != 0
            ? std::max(2.0, 300.0 * (1.0 - std::exp(-inland_m(to_sea[i]) / 4'000.0)) * (1.0 + 0.4 * rough))
            : -std::max(3.0,
                        deepest_m * (1.0 - std::exp(-inland_m(to_land[i]) / 700.0)) * (1.0 + 0.2 * rough));
    relief.elevation_m[i] = static_cast<float>(std::round(metres * 10.0) / 10.0);
  }
  return relief;
}

/// The amplitude of the tide over the frame of the currents, and which cells are land.
struct StraitTide {
  std::vector<bool> land;
  std::vector<double> bed_m;
  Flow amplitude;

  [[nodiscard]] CurrentLayer at(core::Seconds since_start, double depth_m) const {
    const double strength = springs_and_neaps(since_start - core::Seconds{highest_tide_s});
    CurrentLayer layer{amplitude, {}};
    for (std::size_t i = 0; i < land.size(); ++i) {
      const bool masked = land[i] || depth_m > bed_m[i];
      // Friction at the bed slows the water: the current is a tenth weaker at the deepest samples.
      const double share = masked ? 0.0 : strength * (1.0 - 0.1 * depth_m / strait_depths_m.back());
      layer.flow.east[i] *= share;
      layer.flow.north[i] *= share;
      layer.masked.push_back(masked);
    }
    return layer;
  }
};

StraitTide strait_tide(const Relief& relief, const std::vector<geo::Polygon>& land) {
  StraitTide tide{{}, mean_depth_m(relief, strait_current_frame), {}};
  const std::vector<std::uint8_t> mask = land_mask(strait_current_frame, land);
  for (std::size_t i = 0; i < mask.size(); ++i) tide.land.push_back(mask[i] != 0 || tide.bed_m[i] <= 0.0);
  const double north_deg = strait_area.north_deg + 0.01;
  const Gate west{
      {strait_area.west_deg - 0.01, strait_area.south_deg, strait_area.west_deg + 0.001, north_deg}, 1.0};
  const Gate east{
      {strait_area.east_deg - 0.001, strait_area.south_deg, strait_area.east_deg + 0.01, north_deg}, -1.0};
  tide.amplitude = tidal_flow(strait_current_frame, tide.land, tide.bed_m, {west, east});
  scale_to_speed(tide.amplitude, strongest_tide_m_s, 0.002);
  return tide;
}

}  // namespace

std::vector<std::filesystem::path> write_strait(const std::filesystem::path& dir, std::uint64_t seed,
                                                core::UtcTime start) {
  const std::vector<std::filesystem::path> files{dir / "strait-synthetic-bathymetry.tif",
                                                 dir / "strait-synthetic-currents.nc",
                                                 dir / "strait-synthetic-coastline.geojson"};
  const SmoothNoise bends{seed, 3};
  const std::vector<geo::Polygon> land{shore(1.0, bends), shore(-1.0, bends)};
  const Relief relief = strait_relief(land, seed);
  const StraitTide tide = strait_tide(relief, land);

  write_bathymetry(files[0], relief.frame, relief.elevation_m,
                   "Depths of an invented strait: synthetic, not for navigation. Metres, positive up.");
  std::vector<core::UtcTime> times;
  for (int hour = 0; hour <= strait_hours; ++hour) times.push_back(start + std::chrono::hours{hour});
  write_currents(
      files[1],
      {.title = "Tide in an invented strait (synthetic, not for navigation)",
       .comment = "Synthetic, not for navigation: a tide (M2, S2) through an invented strait, "
                  "from a stream function. No tide was predicted.",
       .frame = strait_current_frame,
       .depth_m = {strait_depths_m.begin(), strait_depths_m.end()},
       .times = times,
       .layer = [&](core::UtcTime time, double depth_m) { return tide.at(time - start, depth_m); }});
  write_coastline(files[2], land, strait_area,
                  {.name = "Shores of an invented strait (synthetic, not for navigation)",
                   .description = "Synthetic, not for navigation: there is no land in this place.",
                   .source = {},
                   .license = "CC0-1.0"});
  return files;
}

}  // namespace floeplan::demo
