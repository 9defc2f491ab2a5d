#include <algorithm>
#include <cmath>

#include "storage/demo/disko.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/smooth_noise.hpp"

namespace floeplan::demo {
namespace {

constexpr double half_length_m = 21'000.0;  // half the length of the ice field from east to west
constexpr double half_width_m = 13'000.0;
constexpr double opening_m = 3'000.0;  // radius of the patch of open water
constexpr double edge_m = 2'500.0;     // width of the zone in which the ice thins out
constexpr double floe_scale_m = 6'000.0;
constexpr double drift_m_s = 2'000.0 / 86'400.0;  // westwards

/// Share of ice near the edge of the field: from 0 outside to 1 inside, changing over `edge_m`.
double inside(double distance_to_edge_m) {
  const double share = std::clamp(0.5 + distance_to_edge_m / edge_m, 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace

IceLayer make_disko_ice(const Relief& relief, const RasterFrame& frame, std::uint64_t seed,
                        core::Seconds since_start) {
  const SmoothNoise noise{seed + 31U, 3};
  const std::vector<double> bed_m = mean_depth_m(relief, frame);
  IceLayer layer;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const geo::LonLat place = frame.centre(i);
    const double x = (place.lon_deg - disko::ice_field.lon_deg) * disko::earth.metres_per_degree_lon() +
                     drift_m_s * since_start.count();
    const double y = (place.lat_deg - disko::ice_field.lat_deg) * metres_per_degree_lat;
    const double roughness = noise.at(x / floe_scale_m, y / floe_scale_m);
    const double off_centre = std::hypot(x / half_length_m, y / half_width_m);
    const double field = inside((1.0 - off_centre) * half_width_m + 1500.0 * roughness);
    const double opening = inside(opening_m - std::hypot(x, y));
    layer.concentration.push_back(std::clamp(field * (1.0 - opening) * (0.9 + 0.1 * roughness), 0.0, 1.0));
    layer.thickness_m.push_back(layer.concentration.back() > 0.0 ? 0.6 + 0.3 * roughness : 0.0);
    layer.masked.push_back(bed_m[i] <= 0.0);
  }
  return layer;
}

}  // namespace floeplan::demo
