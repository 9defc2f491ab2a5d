#include "engine/tide/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace floeplan::tide {
namespace {

/// Time between two computations of the nodal corrections; short compared with the 18.6 years of the node.
constexpr core::Seconds block{86'400.0};

}  // namespace

std::complex<double> harmonic_value(double amplitude, double greenwich_phase_deg) {
  return std::polar(1.0, -core::degrees_to_radians(greenwich_phase_deg)) * amplitude;
}

double predict(std::span<const HarmonicConstant> constants, core::UtcTime time) {
  if (!std::isfinite(core::unix_seconds(time)))
    throw std::invalid_argument{"a tide was asked for at a time that is not finite"};
  const MeanLongitudes longitudes = mean_longitudes(time);
  double sum = 0.0;
  for (const HarmonicConstant& constant : constants)
    sum += std::real(constant.value * nodal_factor(constant.constituent, longitudes) *
                     equilibrium_phasor(constant.constituent, longitudes));
  return sum;
}

PhasorTable::PhasorTable(std::vector<Constituent> constituents, core::UtcTime start, core::Seconds step,
                         std::size_t count)
    : constituents_{std::move(constituents)}, count_{count} {
  if (!std::isfinite(core::unix_seconds(start)) || !(step.count() > 0.0) || !std::isfinite(step.count()))
    throw std::invalid_argument{"phasors need a finite start and a step above zero"};
  phasors_.resize(count * constituents_.size());
  const auto steps_a_block = static_cast<std::size_t>(std::max(1.0, std::floor(block / step)));
  for (std::size_t first = 0; first < count; first += steps_a_block) {
    const std::size_t in_block = std::min(steps_a_block, count - first);
    const core::UtcTime begin = start + static_cast<double>(first) * step;
    const MeanLongitudes at_begin = mean_longitudes(begin);
    const MeanLongitudes at_middle = mean_longitudes(begin + 0.5 * static_cast<double>(in_block) * step);
    for (std::size_t c = 0; c < constituents_.size(); ++c) {
      const std::complex<double> turn = std::polar(1.0, angular_speed(constituents_[c]) * step.count());
      std::complex<double> phasor =
          nodal_factor(constituents_[c], at_middle) * equilibrium_phasor(constituents_[c], at_begin);
      for (std::size_t i = 0; i < in_block; ++i) {
        phasors_[(first + i) * constituents_.size() + c] = phasor;
        phasor *= turn;
      }
    }
  }
}

}  // namespace floeplan::tide
