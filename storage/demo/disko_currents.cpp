#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "storage/demo/bell.hpp"
#include "storage/demo/disko.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/land_mask.hpp"
#include "storage/demo/tidal_flow.hpp"

namespace floeplan::demo {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
// the tide in the bay turns this much before the fjord's, which widens the tidal ellipses
constexpr double bay_lag_s = 3000.0;
constexpr double eddy_life_s = 6.0 * 86400.0;
constexpr int eddies = 8;
constexpr double fastest_m_s = 0.75;

const Gate western{{-54.51, 68.72, -54.49, 69.42}, 0.0};
const Gate vaigat{{-52.00, 69.59, -51.30, 69.61}, 0.0};
const Gate icefjord{{-50.51, 69.14, -50.49, 69.225}, 0.0};

double uniform(std::mt19937_64& rng, double low, double high) {
  return low + (high - low) * static_cast<double>(rng() >> 11) * 0x1.0p-53;
}

/// The outflow of the icefjord as a jet along the line `disko::outflow`; the jet widens with the distance
/// from the fjord's head.
Flow outflow_jet(const RasterFrame& frame, const std::vector<bool>& land) {
  std::vector<double> resistance(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const BesideLine beside_jet = beside(disko::outflow, frame.centre(i), disko::earth);
    const double width_m = 2400.0 + 0.09 * beside_jet.along_m;
    resistance[i] =
        1.0 - 0.96 * std::exp(-beside_jet.along_m / 150'000.0) * bell(beside_jet.across_m, width_m);
  }
  return stream_flow(frame, land, resistance,
                     {with_inflow(icefjord, 1.0), with_inflow(vaigat, -0.75), with_inflow(western, -0.25)},
                     std::vector<double>(frame.size()));
}

struct Eddy {
  geo::LonLat centre;
  double radius_m{};
  double spin{};
};

Flow spun_flow(const RasterFrame& frame, const std::vector<bool>& land, const std::vector<Eddy>& whirls) {
  std::vector<double> spin(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    for (const Eddy& eddy : whirls)
      spin[i] += eddy.spin * bell(disko::earth.distance_m(frame.centre(i), eddy.centre), eddy.radius_m);
  }
  return stream_flow(frame, land, std::vector<double>(frame.size(), 1.0), {}, spin);
}

std::vector<Eddy> random_eddies(std::mt19937_64& rng) {
  std::vector<Eddy> whirls;
  for (int i = 0; i < eddies; ++i) {
    const geo::LonLat centre{uniform(rng, -54.2, -51.5), uniform(rng, 68.85, 69.35)};
    const double radius_m = uniform(rng, 4000.0, 7000.0);
    whirls.push_back(
        {centre, radius_m, (i % 2 == 0 ? 1.0 : -1.0) * uniform(rng, 0.6, 1.0) * 5000.0 / radius_m});
  }
  return whirls;
}

std::vector<Eddy> drifted(std::vector<Eddy> whirls, std::mt19937_64& rng) {
  for (Eddy& eddy : whirls) {
    eddy.centre.lon_deg += uniform(rng, -0.22, 0.05);
    eddy.centre.lat_deg += uniform(rng, -0.04, 0.06);
  }
  return whirls;
}

double tide(core::UtcTime time, double lag_s) {
  return springs_and_neaps(core::Seconds{core::unix_seconds(time) - lag_s});
}

/// Strength of each part at a depth, as a share of its strength at the surface.
double tide_at(double depth_m, double bed_m) { return 1.0 - 0.3 * (depth_m / bed_m) * (depth_m / bed_m); }
double outflow_at(double depth_m) { return bell(depth_m, 60.0) - 0.12 * bell(depth_m - 170.0, 70.0); }
double circulation_at(double depth_m) { return std::exp(-depth_m / 350.0); }
double eddies_at(double depth_m) { return std::exp(-depth_m / 160.0); }

}  // namespace

RasterFrame DiskoCurrents::frame() { return {-54.5125, 68.395, 0.025, 0.01, 161, 121}; }

DiskoCurrents::DiskoCurrents(const Relief& relief, const std::vector<geo::Polygon>& land, std::uint64_t seed,
                             core::UtcTime start)
    : bed_m_{mean_depth_m(relief, frame())}, start_{start} {
  const RasterFrame nodes = frame();
  const std::vector<std::uint8_t> mask = land_mask(nodes, land);
  for (std::size_t i = 0; i < nodes.size(); ++i) land_.push_back(mask[i] != 0 || bed_m_[i] <= 0.0);

  std::mt19937_64 rng{seed};
  const double gyre_m_s = uniform(rng, 0.09, 0.11);
  const double outflow_m_s = uniform(rng, 0.34, 0.38);
  const std::vector<Eddy> early = random_eddies(rng);
  const std::vector<Eddy> late = drifted(early, rng);
  outflow_phase_rad_ = uniform(rng, 0.0, turn_rad);

  fjord_tide_ = tidal_flow(nodes, land_, bed_m_, {with_inflow(western, 1.0), with_inflow(icefjord, -1.0)});
  bay_tide_ = tidal_flow(nodes, land_, bed_m_, {with_inflow(western, 1.0), with_inflow(vaigat, -1.0)});
  circulation_ = spun_flow(nodes, land_, {{{-52.35, 69.12}, 17000.0, 1.0}, {{-53.6, 69.05}, 12000.0, 0.5}});
  outflow_ = outflow_jet(nodes, land_);
  eddies_early_ = spun_flow(nodes, land_, early);
  eddies_late_ = spun_flow(nodes, land_, late);
  scale_to_speed(fjord_tide_, 0.34, 0.001);
  scale_to_speed(bay_tide_, 0.16, 0.01);
  scale_to_speed(circulation_, gyre_m_s, 0.01);
  scale_to_speed(outflow_, outflow_m_s, 0.004);
  scale_to_speed(eddies_early_, 0.08, 0.01);
  scale_to_speed(eddies_late_, 0.08, 0.01);
}

bool DiskoCurrents::is_masked(std::size_t at, double depth_m) const {
  return land_[at] || depth_m > bed_m_[at];
}

Flow DiskoCurrents::at(double depth_m, core::UtcTime time) const {
  const double elapsed_s = (time - start_).count();
  const double age = std::clamp(elapsed_s / eddy_life_s, 0.0, 1.0);
  const double fjord_tide = tide(time, 0.0);
  const double bay_tide = tide(time, -bay_lag_s);
  const double outflow = outflow_at(depth_m) *
                         (1.0 + 0.15 * std::sin(turn_rad * elapsed_s / (2.6 * 86400.0) + outflow_phase_rad_));
  const double circulation = circulation_at(depth_m);
  const double early = eddies_at(depth_m) * (1.0 - age);
  const double late = eddies_at(depth_m) * age;

  Flow flow{std::vector<double>(land_.size()), std::vector<double>(land_.size())};
  for (std::size_t i = 0; i < land_.size(); ++i) {
    if (is_masked(i, depth_m)) continue;
    const double tidal = tide_at(depth_m, bed_m_[i]);
    const auto sum = [&](std::vector<double> Flow::* part) {
      return tidal * (fjord_tide * (fjord_tide_.*part)[i] + bay_tide * (bay_tide_.*part)[i]) +
             outflow * (outflow_.*part)[i] + circulation * (circulation_.*part)[i] +
             early * (eddies_early_.*part)[i] + late * (eddies_late_.*part)[i];
    };
    const double east = sum(&Flow::east);
    const double north = sum(&Flow::north);
    const double held = std::min(1.0, fastest_m_s / std::max(std::hypot(east, north), 1e-12));
    flow.east[i] = held * east;
    flow.north[i] = held * north;
  }
  return flow;
}

}  // namespace floeplan::demo
