#pragma once

#include <random>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// Model of the error of a current forecast: a random flow without divergence, the same at every depth. The
/// covariance of its stream function is a Gaussian bell in space and in time.
struct CurrentErrorModel {
  core::MetresPerSecond standard_deviation{};  // of each component
  core::Metres length_scale{};                 // standard deviation of the bell in space
  core::Seconds time_scale{};                  // standard deviation of the bell in time

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The currents with one random error of the model added.
/// Frame    the error is computed east and north in a plane that touches the Earth at the middle of the grid
/// Accuracy statistics of the model within a few percent: 64 waves approximate the continuum
/// Source   random Fourier features: Rahimi and Recht 2007, Random features for large-scale kernel machines,
///          NIPS 20
[[nodiscard]] CurrentGrid with_error(const CurrentGrid& currents, const CurrentErrorModel& model,
                                     std::mt19937_64& rng);

}  // namespace floeplan::ocean
