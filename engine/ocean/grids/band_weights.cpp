#include "engine/ocean/grids/band_weights.hpp"

#include <algorithm>

namespace floeplan::ocean {
namespace {

void drop_trailing_zeros(std::vector<double>& weights) {
  while (weights.size() > 1 && weights.back() == 0.0) weights.pop_back();
}

}  // namespace

std::vector<double> band_weights(const std::optional<Axis>& levels_m, std::size_t wet, core::Metres top,
                                 core::Metres bottom) {
  if (!levels_m || wet == 1) return {1.0};
  const auto depth_of = [&](std::size_t level) { return std::max((*levels_m)[level], 0.0); };
  const double lowest_m = depth_of(wet - 1);
  const double top_m = std::min(top.value, lowest_m);
  const double bottom_m = std::min(bottom.value, lowest_m);
  const double thickness_m = bottom_m - top_m;
  const bool is_thin = !(thickness_m > 0.0);

  std::vector<double> weights(wet, 0.0);
  // Above the first level the value of that level counts.
  const double uppermost_m = depth_of(0);
  if (is_thin && top_m <= uppermost_m) return {1.0};
  if (!is_thin && top_m < uppermost_m) weights[0] = (std::min(bottom_m, uppermost_m) - top_m) / thickness_m;
  for (std::size_t level = 1; level < wet; ++level) {
    const double above_m = depth_of(level - 1);
    const double below_m = depth_of(level);
    const double from_m = std::max(top_m, above_m);
    const double to_m = std::min(bottom_m, below_m);
    if (is_thin ? !(above_m < top_m && top_m <= below_m) : !(to_m > from_m)) continue;
    const double amount = is_thin ? 1.0 : (to_m - from_m) / thickness_m;
    const double middle_m = is_thin ? top_m : 0.5 * (from_m + to_m);
    const double share = (middle_m - above_m) / (below_m - above_m);
    weights[level - 1] += amount * (1.0 - share);
    weights[level] += amount * share;
  }
  drop_trailing_zeros(weights);
  return weights;
}

}  // namespace floeplan::ocean
