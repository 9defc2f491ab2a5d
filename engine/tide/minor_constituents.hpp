#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "engine/tide/prediction.hpp"

namespace floeplan::tide {

/// A line that was not observed, as a weighted sum of two that were.
struct MinorConstituent {
  Constituent constituent;
  std::array<std::size_t, 2> majors{};  // positions in the list of lines that was given
  std::array<double, 2> weights{};
};

/// The up to 16 minor lines that models of the eight major ones leave out, for these lines: those that are not already
/// among them. The response of the sea changes little between neighbouring frequencies.
/// Returns  empty when one of Q1, O1, K1, N2, M2, S2 is missing
/// Source   weights: R. D. Ray, perth2, as in the Tide Model Driver (Padman and Erofeeva 2005, Tide Model Driver
///          manual)
[[nodiscard]] std::vector<MinorConstituent> inferable_minors(std::span<const Constituent> majors);

/// The constants with those of the minor lines that can be inferred from them at the end.
[[nodiscard]] std::vector<HarmonicConstant> with_minors(std::vector<HarmonicConstant> constants);

}  // namespace floeplan::tide
