#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "engine/tide/prediction.hpp"

namespace floeplan::tide {

/// A constituent without observed constants, as a weighted sum of two others.
struct MinorConstituent {
  Constituent constituent;
  std::array<std::size_t, 2> majors{};  // indices into the given list of constituents
  std::array<double, 2> weights{};
};

/// The minor constituents, up to 16, that models with the eight major ones leave out and that are not among
/// `majors`. They can be inferred, because the sea's response changes little between neighbouring
/// frequencies.
/// Returns  empty if one of Q1, O1, K1, N2, M2, S2 is missing
/// Source   weights: R. D. Ray, perth2, as in the Tide Model Driver (Padman and Erofeeva 2005, Tide Model
///          Driver manual)
[[nodiscard]] std::vector<MinorConstituent> inferable_minors(std::span<const Constituent> majors);

/// The given constants, followed by constants for the minor constituents that can be inferred from them.
[[nodiscard]] std::vector<HarmonicConstant> with_minors(std::vector<HarmonicConstant> constants);

}  // namespace floeplan::tide
