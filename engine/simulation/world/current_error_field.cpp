#include "engine/simulation/world/current_error_field.hpp"

#include <cmath>
#include <numbers>

#include "engine/core/random.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::simulation {
namespace {

constexpr int wave_count = 64;

}  // namespace

core::Violations CurrentErrorSettings::violations() const {
  messages::Faults faults{"/current_error/"};
  faults.within(rms.value, 0.0, 2.0, "rms_m_s", "0", "2 m/s");
  faults.within(length_scale.value, 100.0, 1e6, "length_scale_m", "100 m", "1000 km");
  faults.within(depth_scale.value, 1.0, 1e5, "depth_scale_m", "1 m", "100 km");
  faults.within(time_scale.count(), 600.0, 30.0 * 86400.0, "time_scale_s", "10 minutes", "30 days");
  return faults.found();
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
