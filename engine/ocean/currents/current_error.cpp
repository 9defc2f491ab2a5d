#include "engine/ocean/currents/current_error.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::ocean {
namespace {

constexpr std::size_t wave_count = 64;
constexpr double metres_per_degree =
    111'195.0;  // metres per degree on a sphere of 6371 km; accurate enough here

struct Wave {
  double k_east;  // radians per metre
  double k_north;
  double omega;  // radians per second
  double phase;
};

std::vector<Wave> draw_waves(const CurrentErrorModel& model, std::mt19937_64& rng) {
  std::vector<Wave> waves;
  for (std::size_t i = 0; i < wave_count; ++i) {
    const double k_east = core::normal(rng) / model.length_scale.value;
    const double k_north = core::normal(rng) / model.length_scale.value;
    const double omega = core::normal(rng) / model.time_scale.count();
    const double phase = 2.0 * std::numbers::pi * core::uniform(rng);
    waves.push_back({k_east, k_north, omega, phase});
  }
  return waves;
}

}  // namespace

core::Violations CurrentErrorModel::violations() const {
  messages::Faults faults;
  faults.require<"not-above">(standard_deviation.value > 0.0 && standard_deviation.value <= 2.0,
                              "/current_error_m_s", "0", "2 m/s");
  faults.require<"not-between">(length_scale.value >= 1000.0 && length_scale.value <= 1e6, "/length_scale_m",
                                "1", "1000 km");
  faults.require<"not-between">(time_scale.count() >= 600.0 && time_scale.count() <= 30.0 * 86400.0,
                                "/time_scale_s", "10 minutes", "30 days");
  return faults.found();
}

CurrentGrid with_error(const CurrentGrid& currents, const CurrentErrorModel& model, std::mt19937_64& rng) {
  CurrentGrid::Samples samples = currents.samples();
  const HorizontalGrid& grid = samples.grid;
  const std::size_t nx = grid.x().size();
  const std::size_t ny = grid.y().size();
  const geo::LonLat middle = grid.place(nx / 2, ny / 2);
  const double east_scale = metres_per_degree * std::cos(middle.lat_deg * std::numbers::pi / 180.0);

  // psi = sigma L sqrt(2/n) sum cos(k.x + omega t + phase). u = -dpsi/dy and v = dpsi/dx have the standard
  // deviation sigma.
  const std::vector<Wave> waves = draw_waves(model, rng);
  const double amplitude = model.standard_deviation.value * model.length_scale.value *
                           std::sqrt(2.0 / static_cast<double>(wave_count));
  const std::size_t levels = samples.depths_m ? samples.depths_m->size() : 1;
  const double epoch_s = samples.times_s.front();
  std::vector<std::pair<double, double>> in_time;  // cosine and sine of omega t, [time][wave]
  for (const double time_s : samples.times_s.nodes()) {
    for (const Wave& wave : waves) {
      const double angle = wave.omega * (time_s - epoch_s);
      in_time.emplace_back(std::cos(angle), std::sin(angle));
    }
  }
  for (std::size_t iy = 0; iy < ny; ++iy) {
    for (std::size_t ix = 0; ix < nx; ++ix) {
      const geo::LonLat place = grid.place(ix, iy);
      const double east_m = east_scale * geo::longitude_difference(middle.lon_deg, place.lon_deg);
      const double north_m = metres_per_degree * (place.lat_deg - middle.lat_deg);
      std::array<std::pair<double, double>, wave_count> in_place;
      for (std::size_t i = 0; i < wave_count; ++i) {
        const double angle = waves[i].k_east * east_m + waves[i].k_north * north_m + waves[i].phase;
        in_place[i] = {std::cos(angle), std::sin(angle)};
      }
      for (std::size_t t = 0; t < samples.times_s.size(); ++t) {
        double u = 0.0;
        double v = 0.0;
        for (std::size_t i = 0; i < wave_count; ++i) {
          const auto& [cos_t, sin_t] = in_time[t * wave_count + i];
          const double sine = in_place[i].second * cos_t + in_place[i].first * sin_t;
          u += waves[i].k_north * sine;
          v -= waves[i].k_east * sine;
        }
        for (std::size_t level = 0; level < levels; ++level) {
          const std::size_t sample = ((t * levels + level) * ny + iy) * nx + ix;
          samples.u[sample] += static_cast<float>(amplitude * u);
          samples.v[sample] += static_cast<float>(amplitude * v);
        }
      }
    }
  }
  return CurrentGrid{std::move(samples), currents.tide()};
}

}  // namespace floeplan::ocean
