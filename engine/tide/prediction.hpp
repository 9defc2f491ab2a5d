#pragma once

#include <complex>
#include <span>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/tide/constituent.hpp"

namespace floeplan::tide {

/// The harmonic constant of one constituent at one place, for an elevation or one component of a current.
struct HarmonicConstant {
  Constituent constituent;
  std::complex<double>
      value;  // A exp(-i g): amplitude, and phase lag behind the equilibrium tide at Greenwich
};

/// The complex constant A exp(-i g).
[[nodiscard]] std::complex<double> harmonic_value(double amplitude, double greenwich_phase_deg);

/// The tide at one time: the sum of f A cos(V + u - g) over the constituents. Slow, because every angle is
/// computed anew.
/// Units    those of the amplitudes
/// Errors   std::invalid_argument for a time that is not finite
[[nodiscard]] double predict(std::span<const HarmonicConstant> constants, core::UtcTime time);

/// Factors for each constituent at equally spaced times, the same for all places. The tide is the real part
/// of the sum of factors times constants, so a place costs one multiplication per constituent.
/// Accuracy nodal corrections are constant for a day at a time: within 3e-4 of the amplitude; 1e-3 for M1 and
/// L2, which the perigee changes faster; for shallow-water constituents the sum over their parents
/// Threads  const members may be called from several threads at once
class PhasorTable {
 public:
  PhasorTable(std::vector<Constituent> constituents, core::UtcTime start, core::Seconds step,
              std::size_t count);

  [[nodiscard]] const std::vector<Constituent>& constituents() const { return constituents_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  /// f exp(i (V + u)) of each constituent at the time start + i * step.
  [[nodiscard]] std::span<const std::complex<double>> at(std::size_t i) const {
    return std::span{phasors_}.subspan(i * constituents_.size(), constituents_.size());
  }

 private:
  std::vector<Constituent> constituents_;
  std::size_t count_;
  std::vector<std::complex<double>> phasors_;  // [time][constituent]
};

}  // namespace floeplan::tide
