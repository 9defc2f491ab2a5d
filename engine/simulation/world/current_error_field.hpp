#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// Error of the current forecast: a random horizontal flow without divergence. The covariance of its stream
/// function is a Gaussian bell in place, depth and time.
struct CurrentErrorSettings {
  core::MetresPerSecond rms{};              // per component; 0: the forecast is exact
  core::Metres length_scale{10'000.0};      // standard deviation of the bell along the surface
  core::Metres depth_scale{200.0};          // standard deviation of the bell in depth
  core::Seconds time_scale{12.0 * 3600.0};  // standard deviation of the bell in time

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// One such error field, drawn from a seed.
/// Frame    east and north of the flight's frame, m/s
/// Accuracy statistics within a few percent: 64 waves approximate the continuum
/// Threads  const members may be called from several threads at once
/// Source   random Fourier features: Rahimi and Recht 2007, Random features for large-scale kernel machines,
///          NIPS 20
class CurrentErrorField {
 public:
  CurrentErrorField() = default;  // no error anywhere
  CurrentErrorField(const CurrentErrorSettings& settings, core::UtcTime epoch, std::uint64_t seed);

  [[nodiscard]] Vector at(Vector place, core::UtcTime time) const;

 private:
  struct Wave {
    double k_east{};  // radians per metre
    double k_north{};
    double k_down{};
    double omega{};  // radians per second
    double phase{};
  };
  std::vector<Wave> waves_;
  double amplitude_m2_s_{};
  core::UtcTime epoch_{};
};

}  // namespace floeplan::simulation
