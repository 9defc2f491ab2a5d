#include "engine/ocean/currents/current_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
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

/// Nodes of a row whose waves are summed together: few enough for the processor's nearest cache, and a known number, so
/// that the compiler vectorises the sums.
constexpr std::size_t nodes_together = 32;

/// Cosine and sine of the angles of one wave.
struct Turns {
  std::array<double, nodes_together> cosine;
  std::array<double, nodes_together> sine;
};

/// The waves at some nodes of a row at the first time.
using WavesInPlace = std::array<Turns, wave_count>;

/// Places of nodes in a plane that touches the Earth at the middle of the grid.
class MiddlePlane {
 public:
  explicit MiddlePlane(const HorizontalGrid& grid)
      : middle_{grid.place(grid.x().size() / 2, grid.y().size() / 2)},
        east_scale_{metres_per_degree * std::cos(middle_.lat_deg * std::numbers::pi / 180.0)} {}

  [[nodiscard]] double angle(const Wave& wave, geo::LonLat place) const {
    const double east_m = east_scale_ * geo::longitude_difference(middle_.lon_deg, place.lon_deg);
    const double north_m = metres_per_degree * (place.lat_deg - middle_.lat_deg);
    return wave.k_east * east_m + wave.k_north * north_m + wave.phase;
  }

 private:
  geo::LonLat middle_;
  double east_scale_;
};

/// Cosine and sine of each wave's turn since the first time, [time][wave].
std::vector<std::pair<double, double>> turns_in_time(const std::vector<Wave>& waves, const Axis& times_s) {
  std::vector<std::pair<double, double>> turns;
  for (const double time_s : times_s.nodes()) {
    for (const Wave& wave : waves) {
      const double angle = wave.omega * (time_s - times_s.front());
      turns.emplace_back(std::cos(angle), std::sin(angle));
    }
  }
  return turns;
}

/// Sums the waves at some nodes at one time.
/// `in_time`  the waves' turns since the first time, [wave]
void sum_waves(const std::vector<Wave>& waves, const WavesInPlace& in_place,
               const std::pair<double, double>* in_time, std::array<double, nodes_together>& u,
               std::array<double, nodes_together>& v) {
  u.fill(0.0);
  v.fill(0.0);
  for (std::size_t i = 0; i < wave_count; ++i) {
    const auto [cos_t, sin_t] = in_time[i];
    const auto& [cosine, sine] = in_place[i];
    const double k_east = waves[i].k_east;
    const double k_north = waves[i].k_north;
    for (std::size_t n = 0; n < nodes_together; ++n) {
      const double turned = sine[n] * cos_t + cosine[n] * sin_t;
      u[n] += k_north * turned;
      v[n] -= k_east * turned;
    }
  }
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
  const HorizontalGrid& grid = currents.samples().grid;
  const std::size_t nx = grid.x().size();
  const std::size_t times = currents.samples().times_s.size();

  // psi = sigma L sqrt(2/n) sum cos(k.x + omega t + phase). u = -dpsi/dy and v = dpsi/dx have the standard
  // deviation sigma.
  const std::vector<Wave> waves = draw_waves(model, rng);
  const double amplitude = model.standard_deviation.value * model.length_scale.value *
                           std::sqrt(2.0 / static_cast<double>(wave_count));
  const std::vector<std::pair<double, double>> in_time = turns_in_time(waves, currents.samples().times_s);
  const MiddlePlane plane{grid};
  CurrentGrid::Added error{std::vector<float>(times * grid.size()), std::vector<float>(times * grid.size())};
  const auto in_place = std::make_unique<WavesInPlace>();
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t first = 0; first < nx; first += nodes_together) {
      const std::size_t count = std::min(nodes_together, nx - first);
      for (std::size_t n = 0; n < count; ++n) {
        const geo::LonLat place = grid.place(first + n, iy);
        for (std::size_t i = 0; i < wave_count; ++i) {
          const double angle = plane.angle(waves[i], place);
          (*in_place)[i].cosine[n] = std::cos(angle);
          (*in_place)[i].sine[n] = std::sin(angle);
        }
      }
      for (std::size_t t = 0; t < times; ++t) {
        std::array<double, nodes_together> u;
        std::array<double, nodes_together> v;
        sum_waves(waves, *in_place, in_time.data() + t * wave_count, u, v);
        const std::size_t begin = (t * grid.y().size() + iy) * nx + first;
        for (std::size_t n = 0; n < count; ++n) {
          error.u[begin + n] = static_cast<float>(amplitude * u[n]);
          error.v[begin + n] = static_cast<float>(amplitude * v[n]);
        }
      }
    }
  }
  return currents.with_added(std::move(error));
}

}  // namespace floeplan::ocean
