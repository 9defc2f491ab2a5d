#pragma once

#include <array>
#include <cmath>
#include <random>

#include "engine/core/random.hpp"
#include "engine/simulation/sensors/janus.hpp"

namespace floeplan::simulation {

/// Noise of the cells of one beam with unit variance; neighbours are correlated as in the settings.
using CellNoise = std::array<double, most_adcp_cells>;

/// Each value is a weighted sum of two consecutive independent deviates.
inline void draw_cell_noise(const AdcpSettings& settings, std::mt19937_64& rng, CellNoise& noise) {
  const double angle = 0.5 * std::asin(2.0 * settings.neighbour_correlation);
  const double own = std::cos(angle);
  const double next = std::sin(angle);
  double last = core::normal(rng);
  for (int cell = 0; cell < settings.cells; ++cell) {
    const double fresh = core::normal(rng);
    noise[static_cast<std::size_t>(cell)] = own * last + next * fresh;
    last = fresh;
  }
}

/// Error of the velocity over ground to which a profile is referred.
struct ReferenceError {
  double east_m_s{};
  double north_m_s{};
};

/// The value of the error process after `elapsed_s`; for the first one pass infinity.
/// Source   Gelb 1974, Applied optimal estimation, section 3.8: first-order Gauss-Markov process
[[nodiscard]] inline ReferenceError next_reference_error(const AdcpSettings& settings,
                                                         const ReferenceError& last, double elapsed_s,
                                                         std::mt19937_64& rng) {
  const double kept = std::exp(-elapsed_s / settings.reference_time_s);
  const double fresh = settings.reference_sigma_m_s * std::sqrt(1.0 - kept * kept);
  const double east_m_s = kept * last.east_m_s + fresh * core::normal(rng);
  return {east_m_s, kept * last.north_m_s + fresh * core::normal(rng)};
}

}  // namespace floeplan::simulation
