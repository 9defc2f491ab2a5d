#pragma once

#include <random>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/currents/current_grid.hpp"

namespace floeplan::ocean {

/// How far currents of a forecast may be from the truth: a random flow without divergence, the same at every depth,
/// whose stream function has the covariance of a Gaussian bell in place and in time.
struct CurrentErrorModel {
  core::MetresPerSecond standard_deviation{};  // of each component
  core::Metres length_scale{};                 // standard deviation of the bell
  core::Seconds time_scale{};                  // the same in time

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The currents with one error of the model added.
/// Frame    the error is laid out east and north in a plane that touches the middle of the grid
/// Accuracy statistics of the model within a few percent: 64 waves stand for the continuum
/// Source   random Fourier features: Rahimi and Recht 2007, Random features for large-scale kernel machines, NIPS 20
[[nodiscard]] CurrentGrid with_error(const CurrentGrid& currents, const CurrentErrorModel& model,
                                     std::mt19937_64& rng);

}  // namespace floeplan::ocean
