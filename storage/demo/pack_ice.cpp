#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "storage/demo/bathymetry_file.hpp"
#include "storage/demo/bell.hpp"
#include "storage/demo/current_file.hpp"
#include "storage/demo/flat_earth.hpp"
#include "storage/demo/geojson_files.hpp"
#include "storage/demo/ice_file.hpp"
#include "storage/demo/scenarios.hpp"
#include "storage/demo/smooth_noise.hpp"

namespace floeplan::demo {
namespace {

constexpr geo::LonLat middle_of_pack{-64.0, 73.0};
constexpr FlatEarth pack_earth{73.0};
// cells of about 1 km; 131 km by 61 km
constexpr RasterFrame pack_frame{-66.01, 72.7255, 0.03, 0.009, 134, 61};
constexpr double half_belt_m = 40'000.0;
constexpr double pack_edge_m = 3'000.0;  // width of the zone in which the ice thins out
constexpr double drift_south_m_s = 2'500.0 / 86'400.0;
constexpr double half_lead_east_m = 7'000.0;
constexpr double half_lead_north_m = 14'000.0;
constexpr double island_radius_m = 2'000.0;
constexpr int pack_hours = 144;
constexpr std::array pack_depths_m{0.0, 50.0, 200.0, 400.0};

/// Metres east and north of the middle of the frame.
struct FromMiddle {
  double x_m{};
  double y_m{};
};

// Where the ice is when a glider comes there, one to three days after the start, the straight line crosses the
// western and the eastern lead. The icebergs are on the line between them, and the third lead is north of these.
constexpr std::array<FromMiddle, 3> leads{{{-24'000.0, 6'000.0}, {0.0, 20'000.0}, {24'000.0, 8'000.0}}};
constexpr std::array<FromMiddle, 2> bergs{{{-4'800.0, 8'500.0}, {-800.0, 8'500.0}}};
constexpr FromMiddle island{52'000.0, 22'000.0};

/// An eddy; positive speed turns anticlockwise.
struct PackEddy {
  FromMiddle centre;
  double radius_m{};
  double fastest_m_s{};
};

constexpr std::array<PackEddy, 4> pack_eddies{{{{-42'000.0, 8'000.0}, 9'000.0, 0.09},
                                               {{-12'000.0, -12'000.0}, 8'000.0, -0.08},
                                               {{14'000.0, 14'000.0}, 8'000.0, 0.08},
                                               {{44'000.0, -9'000.0}, 9'000.0, -0.09}}};

FromMiddle from_middle(geo::LonLat place) {
  return {(place.lon_deg - middle_of_pack.lon_deg) * pack_earth.metres_per_degree_lon(),
          (place.lat_deg - middle_of_pack.lat_deg) * metres_per_degree_lat};
}

geo::LonLat place_at(FromMiddle here) {
  return {middle_of_pack.lon_deg + here.x_m / pack_earth.metres_per_degree_lon(),
          middle_of_pack.lat_deg + here.y_m / metres_per_degree_lat};
}

double from_island_m(FromMiddle here) { return std::hypot(here.x_m - island.x_m, here.y_m - island.y_m); }

bool is_island(FromMiddle here) { return from_island_m(here) < island_radius_m; }

/// Share of ice: 0 well outside of the edge, 1 well inside.
double share_inside(double depth_inside_m) {
  const double share = std::clamp(0.5 + depth_inside_m / pack_edge_m, 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

/// The ice in every cell of the frame, `since_start` after the start.
IceLayer pack_ice(const SmoothNoise& noise, core::Seconds since_start) {
  IceLayer layer;
  for (std::size_t i = 0; i < pack_frame.size(); ++i) {
    const FromMiddle here = from_middle(pack_frame.centre(i));
    const double y_m = here.y_m + drift_south_m_s * since_start.count();  // where this ice was at the start
    const double rough = noise.at(here.x_m / 7'000.0, y_m / 7'000.0);
    double open = 0.0;
    for (const FromMiddle& lead : leads) {
      const double off =
          std::hypot((here.x_m - lead.x_m) / half_lead_east_m, (y_m - lead.y_m) / half_lead_north_m);
      open = std::max(open, share_inside((1.0 - off) * half_lead_east_m + 0.5 * pack_edge_m));
    }
    const double belt = share_inside(half_belt_m - std::abs(here.x_m) + 2'000.0 * rough);
    const double concentration = std::clamp(belt * (1.0 - open) * (0.95 + 0.05 * rough), 0.0, 1.0);
    layer.concentration.push_back(concentration);
    layer.thickness_m.push_back(concentration > 0.0 ? 1.2 + 0.4 * rough : 0.0);
    layer.masked.push_back(is_island(here));
  }
  return layer;
}

/// A steady drift to the south-east, with eddies that strengthen and weaken; all decrease with depth.
CurrentLayer pack_currents(core::Seconds since_start, double depth_m) {
  CurrentLayer layer{{std::vector<double>(pack_frame.size()), std::vector<double>(pack_frame.size())},
                     std::vector<bool>(pack_frame.size())};
  const double fading = std::exp(-depth_m / 300.0);
  const double days = since_start.count() / 86'400.0;
  for (std::size_t i = 0; i < pack_frame.size(); ++i) {
    const FromMiddle here = from_middle(pack_frame.centre(i));
    double east = 0.02;
    double north = -0.03;
    for (std::size_t k = 0; k < pack_eddies.size(); ++k) {
      const PackEddy& eddy = pack_eddies[k];
      const double x = (here.x_m - eddy.centre.x_m) / eddy.radius_m;
      const double y = (here.y_m - eddy.centre.y_m) / eddy.radius_m;
      const double swell = 1.0 + 0.2 * std::sin(2.0 * std::numbers::pi * days / 4.0 + static_cast<double>(k));
      // The eddy's speed is highest at one radius from its centre.
      const double turning = eddy.fastest_m_s * swell * std::exp(0.5 * (1.0 - x * x - y * y));
      east -= turning * y;
      north += turning * x;
    }
    layer.masked[i] = is_island(here);
    layer.flow.east[i] = fading * east;
    layer.flow.north[i] = fading * north;
  }
  return layer;
}

std::vector<float> pack_elevation_m(std::uint64_t seed) {
  const SmoothNoise hills{seed + 1, 4};
  std::vector<float> elevation_m;
  for (std::size_t i = 0; i < pack_frame.size(); ++i) {
    const FromMiddle here = from_middle(pack_frame.centre(i));
    const double deep_m = -1'500.0 - 400.0 * hills.at(here.x_m / 25'000.0, here.y_m / 25'000.0);
    const double slope = bell(from_island_m(here), 2.0 * island_radius_m);
    elevation_m.push_back(static_cast<float>(std::round(deep_m * (1.0 - 1.3 * slope))));
  }
  return elevation_m;
}

geo::Polygon island_shore() {
  geo::Polygon land;
  constexpr int corners = 36;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    land.outer.push_back(place_at(
        {island.x_m + island_radius_m * std::cos(angle), island.y_m + island_radius_m * std::sin(angle)}));
  }
  return land;
}

std::vector<ocean::Iceberg> pack_icebergs(core::UtcTime start) {
  std::vector<ocean::Iceberg> icebergs;
  for (const FromMiddle& here : bergs) {
    ocean::Iceberg berg;
    berg.id = "PACK-" + std::to_string(icebergs.size() + 1);
    berg.place = place_at(here);
    berg.observed = start;
    berg.size = ocean::IcebergSize::large;
    berg.length = core::Metres{160.0};
    berg.draft = core::Metres{106.0};  // Barker et al. 2004, as in disko
    berg.position_uncertainty = core::Metres{300.0};
    berg.method = "SAT-HIGH";
    icebergs.push_back(berg);
  }
  return icebergs;
}

}  // namespace

std::vector<std::filesystem::path> write_pack_ice(const std::filesystem::path& dir, std::uint64_t seed,
                                                  core::UtcTime start) {
  const std::vector<std::filesystem::path> files{
      dir / "pack-ice-synthetic-bathymetry.tif", dir / "pack-ice-synthetic-currents.nc",
      dir / "pack-ice-synthetic-ice.nc", dir / "pack-ice-synthetic-icebergs.geojson",
      dir / "pack-ice-synthetic-coastline.geojson"};
  write_bathymetry(
      files[0], pack_frame, pack_elevation_m(seed),
      "Depths below invented pack ice in Baffin Bay: synthetic, not for navigation. Metres, positive up.");
  std::vector<core::UtcTime> hours;
  std::vector<core::UtcTime> days;
  for (int hour = 0; hour <= pack_hours; ++hour) {
    hours.push_back(start + std::chrono::hours{hour});
    if (hour % 24 == 0) days.push_back(hours.back());
  }
  write_currents(
      files[1],
      {.title = "Currents below invented pack ice (synthetic, not for navigation)",
       .comment = "Synthetic, not for navigation: a weak drift to the south-east and four eddies "
                  "from formulas. No forecast model was run.",
       .frame = pack_frame,
       .depth_m = {pack_depths_m.begin(), pack_depths_m.end()},
       .times = hours,
       .layer = [&](core::UtcTime time, double depth_m) { return pack_currents(time - start, depth_m); }});
  const SmoothNoise floes{seed + 31U, 3};
  write_ice(files[2],
            {.title = "Pack ice with leads (synthetic, not for navigation)",
             .comment = "Synthetic, not for navigation: a belt of closed ice with three leads, drifting "
                        "southwards. No ice was observed.",
             .frame = pack_frame,
             .times = days,
             .layer = [&](core::UtcTime time) { return pack_ice(floes, time - start); }});
  write_icebergs(files[3], pack_icebergs(start),
                 {.name = "Icebergs in invented pack ice (synthetic, not for navigation)",
                  .description = "Synthetic, not for navigation. No berg here was ever seen.",
                  .source = ""});
  write_coastline(files[4], {island_shore()},
                  {middle_of_pack.lon_deg - 2.5, middle_of_pack.lat_deg - 0.5, middle_of_pack.lon_deg + 2.5,
                   middle_of_pack.lat_deg + 0.5},
                  {.name = "An invented island in Baffin Bay (synthetic, not for navigation)",
                   .description = "Synthetic, not for navigation. There is no land in this place.",
                   .source = ""});
  return files;
}

}  // namespace floeplan::demo
