#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/grids/axis.hpp"

namespace floeplan::ocean {

/// Weights of the levels in the mean over the depths from top to bottom of a column of water that is linear
/// between levels. The weighted sum of the levels equals CurrentColumn::mean.
/// `levels_m`  positive down; empty: one level that counts for every depth
/// `wet`       number of levels with water, from the first one on; at least one
/// Returns     weights of the first levels, which add up to one; those of further levels are zero
[[nodiscard]] std::vector<double> band_weights(const std::optional<Axis>& levels_m, std::size_t wet,
                                               core::Metres top, core::Metres bottom);

}  // namespace floeplan::ocean
