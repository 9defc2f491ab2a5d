#include "engine/simulation/world/current_error_field.hpp"

#include <cmath>
#include <numbers>

#include "engine/core/random.hpp"

namespace floeplan::simulation {
namespace {

constexpr int wave_count = 64;

}  // namespace

core::Violations CurrentErrorSettings::violations() const {
  core::Violations found;
  const auto require = [&](bool holds, const char* field, const char* rule) {
    if (!holds) found.push_back({field, rule});
  };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  require(within(rms.value, 0.0, 2.0), "/current_error/rms_m_s", "must be between 0 and 2 m/s");
  require(within(length_scale.value, 100.0, 1e6), "/current_error/length_scale_m",
          "must be between 100 m and 1000 km");
  require(within(depth_scale.value, 1.0, 1e5), "/current_error/depth_scale_m",
          "must be between 1 m and 100 km");
  require(within(time_scale.count(), 600.0, 30.0 * 86400.0), "/current_error/time_scale_s",
          "must be between 10 minutes and 30 days");
  return found;
}

CurrentErrorField::CurrentErrorField(const CurrentErrorSettings& settings, core::UtcTime epoch,
                                     std::uint64_t seed)
    : epoch_{epoch} {
  if (settings.rms.value == 0.0) return;
  auto rng = core::random_stream(seed, "current error");
  for (int i = 0; i < wave_count; ++i) {
    Wave wave;
    wave.k_east = core::normal(rng) / settings.length_scale.value;
    wave.k_north = core::normal(rng) / settings.length_scale.value;
    wave.k_down = core::normal(rng) / settings.depth_scale.value;
    wave.omega = core::normal(rng) / settings.time_scale.count();
    wave.phase = 2.0 * std::numbers::pi * core::uniform(rng);
    waves_.push_back(wave);
  }
  amplitude_m2_s_ = settings.rms.value * settings.length_scale.value * std::sqrt(2.0 / wave_count);
}

Vector CurrentErrorField::at(Vector place, core::UtcTime time) const {
  // psi = sum of cosines; u = -dpsi/dnorth, v = dpsi/deast.
  const double elapsed_s = (time - epoch_).count();
  double east = 0.0;
  double north = 0.0;
  for (const Wave& wave : waves_) {
    const double sine = std::sin(wave.k_east * place.east + wave.k_north * place.north +
                                 wave.k_down * place.down + wave.omega * elapsed_s + wave.phase);
    east += wave.k_north * sine;
    north -= wave.k_east * sine;
  }
  return {amplitude_m2_s_ * east, amplitude_m2_s_ * north, 0.0};
}

}  // namespace floeplan::simulation
