#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/grids/axis.hpp"

namespace floeplan::ocean {

/// How much each level counts in the mean over the depths from top to bottom of a column of water, which is linear
/// between levels: what CurrentColumn::mean gives, as a sum of weighted levels.
/// `levels_m`  positive down; empty: one level that stands for every depth
/// `wet`       how many of the levels have water, from the first one on; at least one
/// Returns     weights of the first levels, which add up to one; those beyond count nothing
[[nodiscard]] std::vector<double> band_weights(const std::optional<Axis>& levels_m, std::size_t wet,
                                               core::Metres top, core::Metres bottom);

}  // namespace floeplan::ocean
