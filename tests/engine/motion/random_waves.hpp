#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "engine/motion/edge_time.hpp"
#include "engine/motion/plane_current.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion {

inline constexpr core::MetresPerSecond glider{0.35};

/// A smooth current that changes in place and time: three plane waves of at most 0.07 m/s, 15 to 60 km long,
/// with periods of half a day to two days.
class RandomWaves {
 public:
  explicit RandomWaves(std::mt19937_64& rng) {
    constexpr double turn = 6.283185307179586;
    for (Wave& wave : waves_) {
      const double towards = support::uniform(rng, 0.0, turn);
      const double number_per_m = turn / support::uniform(rng, 15'000.0, 60'000.0);
      const double strength_m_s = support::uniform(rng, 0.0, 0.07);
      const double flow = support::uniform(rng, 0.0, turn);
      wave = {.x_m_s = strength_m_s * std::cos(flow),
              .y_m_s = strength_m_s * std::sin(flow),
              .kx = number_per_m * std::cos(towards),
              .ky = number_per_m * std::sin(towards),
              .rate = turn / support::uniform(rng, 43'200.0, 172'800.0),
              .phase = support::uniform(rng, 0.0, turn)};
    }
  }

  std::optional<CurrentXy> operator()(geo::PlanePoint p, core::Seconds time) const {
    CurrentXy sum;
    for (const Wave& wave : waves_) {
      const double s = std::sin(wave.kx * p.x_m + wave.ky * p.y_m - wave.rate * time.count() + wave.phase);
      sum.x_m_s += s * wave.x_m_s;
      sum.y_m_s += s * wave.y_m_s;
    }
    return sum;
  }

 private:
  struct Wave {
    double x_m_s{};
    double y_m_s{};
    double kx{};
    double ky{};
    double rate{};
    double phase{};
  };
  std::array<Wave, 3> waves_;
};

/// An edge of 1 to 40 km in a random direction.
inline PlaneEdge random_edge(std::mt19937_64& rng) {
  const double length_m = support::uniform(rng, 1'000.0, 40'000.0);
  const double angle = support::uniform(rng, 0.0, 6.283185307179586);
  const geo::PlanePoint from{support::uniform(rng, -5e4, 5e4), support::uniform(rng, -5e4, 5e4)};
  const geo::PlanePoint to{from.x_m + length_m * std::cos(angle), from.y_m + length_m * std::sin(angle)};
  return {from, to, core::Metres{length_m * support::uniform(rng, 0.999, 1.001)}};
}

/// The accuracy that suits these waves: a quarter of the shortest length and period.
inline EdgeAccuracy wave_accuracy(double relative_tolerance) {
  return {.relative_tolerance = relative_tolerance,
          .longest_step = core::Metres{15'000.0 / 4.0},
          .longest_duration = core::Seconds{43'200.0 / 4.0}};
}

}  // namespace floeplan::motion
