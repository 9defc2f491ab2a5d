#include "storage/demo/disko_bathymetry.hpp"

#include <algorithm>
#include <cmath>

#include "storage/demo/bell.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/land_mask.hpp"
#include "storage/demo/smooth_noise.hpp"

namespace floeplan::demo {
namespace {

constexpr RasterFrame relief_frame{
    disko::area.west_deg, disko::area.south_deg, 1.0 / 144.0, 1.0 / 400.0, 576, 480};
constexpr std::size_t share_radius = 14;  // cells of the relief; 4 km
constexpr double fjord_west_deg = -51.22;

/// 1 where `value` is well below zero, 0 where it is well above, 0.5 at zero.
double fading(double value, double width) { return 0.5 * (1.0 - std::tanh(value / width)); }

class SeaBed {
 public:
  explicit SeaBed(std::uint64_t seed) : bends_{seed, 3}, roughness_{seed + 1, 5} {}

  /// Depth of the sea, metres, with the distance to the coast and the share of land around.
  [[nodiscard]] double depth_m(geo::LonLat place, double coast_m, double land_share) const {
    const double x_m = place.lon_deg * disko::earth.metres_per_degree_lon();
    const double y_m = place.lat_deg * metres_per_degree_lat;
    const double rough = roughness_.at(x_m / 9000.0, y_m / 9000.0);

    const double open = basin_m(bent(place, x_m, y_m)) * std::max(0.12, 1.0 - 1.35 * land_share);
    const double bay =
        0.85 * open * (1.0 - std::exp(-coast_m / 3500.0)) + 0.15 * open * (1.0 - bell(coast_m, 700.0));
    const double fjord = 780.0 * (1.0 - std::exp(-coast_m / 620.0));
    const double inside = inside_fjord(place);
    const double unsilled = bay + (std::max(bay, fjord) - bay) * inside;
    return std::max(3.0, with_sill(unsilled * (1.0 + 0.22 * rough) + 6.0 * rough, place));
  }

 private:
  /// The place moved by up to 3.5 km of smooth noise, so that no trough runs straight.
  [[nodiscard]] geo::LonLat bent(geo::LonLat place, double x_m, double y_m) const {
    const double east_m = 3500.0 * bends_.at(x_m / 16000.0, y_m / 16000.0);
    const double north_m = 3500.0 * bends_.at(x_m / 16000.0 + 100.0, y_m / 16000.0);
    return {place.lon_deg + east_m / disko::earth.metres_per_degree_lon(),
            place.lat_deg + north_m / metres_per_degree_lat};
  }

  /// 1 in the icefjord, 0 well outside; its mouth is narrower than its inner basin.
  static double inside_fjord(geo::LonLat place) {
    const double half_width_deg = 0.025 + 0.045 * fading(-(place.lon_deg + 51.0) * 100.0, 3.0);
    return fading((fjord_west_deg + 0.05 - place.lon_deg) * 100.0, 1.5) *
           fading((std::abs(place.lat_deg - disko::sill.lat_deg) - half_width_deg) * 100.0, 1.2);
  }

  static double basin_m(geo::LonLat place) {
    const BesideLine main = beside(disko::trough, place, disko::earth);
    const BesideLine north = beside(disko::vaigat_trough, place, disko::earth);
    const double shelf = 250.0 - 90.0 * fading((place.lon_deg + 53.6) * 10.0, 3.0);
    const double trough = (450.0 - shelf) * bell(main.across_m, 6500.0);
    const double northern = (380.0 - shelf) * bell(north.across_m, 6000.0);
    const double deep = 260.0 * bell(disko::earth.distance_m(place, disko::egedesminde_deep), 11000.0);
    return shelf + std::max(trough, northern) + deep;
  }

  /// The moraine rises to a depth of 225 m in its middle; where the bed is shallower already, it stays as it
  /// is.
  static double with_sill(double depth_m, geo::LonLat place) {
    const double x_m = (place.lon_deg - disko::sill.lon_deg) * disko::earth.metres_per_degree_lon();
    const double y_m = (place.lat_deg - disko::sill.lat_deg) * metres_per_degree_lat;
    const double bowed_m = x_m + y_m * y_m / 16000.0;  // an arc, its back to the bay
    const double cap_m = 218.0 + 90.0 * (bowed_m / 1700.0) * (bowed_m / 1700.0);
    if (std::abs(y_m) > 9000.0 || cap_m >= depth_m) return depth_m;
    const double reach = bell(std::max(0.0, std::abs(y_m) - 5000.0), 2000.0);
    return depth_m + (cap_m - depth_m) * reach;
  }

  SmoothNoise bends_;
  SmoothNoise roughness_;
};

double land_height_m(geo::LonLat place, double coast_m, const SmoothNoise& hills) {
  const double x_m = place.lon_deg * disko::earth.metres_per_degree_lon();
  const double y_m = place.lat_deg * metres_per_degree_lat;
  const double hill = 1.0 + 0.5 * hills.at(x_m / 7000.0, y_m / 7000.0);
  return std::max(2.0, 700.0 * (1.0 - std::exp(-coast_m / 5000.0)) * hill);
}

}  // namespace

Relief make_disko_relief(const std::vector<geo::Polygon>& land, std::uint64_t seed) {
  Relief relief{relief_frame, std::vector<float>(relief_frame.size()), land_mask(relief_frame, land)};
  const std::vector<float> to_land = cells_to(relief_frame, relief.land, 1);
  const std::vector<float> to_sea = cells_to(relief_frame, relief.land, 0);
  const std::vector<float> share = land_share(relief_frame, relief.land, share_radius);
  const SeaBed bed{seed};
  const SmoothNoise hills{seed + 2, 4};

  for (std::size_t i = 0; i < relief_frame.size(); ++i) {
    const geo::LonLat place = relief_frame.centre(i);
    // Distances are between cell centres; the coast lies half a cell nearer.
    const double metres =
        relief.land[i] != 0
            ? land_height_m(place, (static_cast<double>(to_sea[i]) - 0.5) * disko_cell_m, hills)
            : -bed.depth_m(place, (static_cast<double>(to_land[i]) - 0.5) * disko_cell_m,
                           static_cast<double>(share[i]));
    relief.elevation_m[i] = static_cast<float>(std::round(metres * 10.0) / 10.0);
  }
  return relief;
}

std::vector<double> mean_depth_m(const Relief& relief, const RasterFrame& frame) {
  std::vector<double> sum(frame.size());
  std::vector<int> cells(frame.size());
  for (std::size_t i = 0; i < relief.frame.size(); ++i) {
    if (relief.land[i] != 0) continue;
    const geo::LonLat place = relief.frame.centre(i);
    const auto column =
        static_cast<std::ptrdiff_t>(std::floor((place.lon_deg - frame.west_deg) / frame.step_lon_deg));
    const auto row =
        static_cast<std::ptrdiff_t>(std::floor((place.lat_deg - frame.south_deg) / frame.step_lat_deg));
    if (column < 0 || row < 0) continue;
    const auto c = static_cast<std::size_t>(column);
    const auto r = static_cast<std::size_t>(row);
    if (c >= frame.columns || r >= frame.rows) continue;
    sum[frame.index(c, r)] -= static_cast<double>(relief.elevation_m[i]);
    ++cells[frame.index(c, r)];
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = cells[i] > 0 ? sum[i] / cells[i] : 0.0;
  return sum;
}

double depth_m(const Relief& relief, geo::LonLat place) {
  const RasterFrame& frame = relief.frame;
  const double column = std::floor((place.lon_deg - frame.west_deg) / frame.step_lon_deg);
  const double row = std::floor((place.lat_deg - frame.south_deg) / frame.step_lat_deg);
  const auto c = static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(frame.columns - 1)));
  const auto r = static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(frame.rows - 1)));
  return -static_cast<double>(relief.elevation_m[frame.index(c, r)]);
}

}  // namespace floeplan::demo
