#include "engine/planning/refinement/kept_points.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::refinement {
namespace {

/// The chain of shortcuts to a point with the least loss, for a given number of legs.
struct ChainEnd {
  double loss{INFINITY};
  std::size_t from{};
};

}  // namespace

std::optional<std::vector<std::size_t>> least_loss(const std::vector<Shortcut>& shortcuts, std::size_t points,
                                                   std::size_t most) {
  std::vector<std::vector<ChainEnd>> best(points, std::vector<ChainEnd>(most + 1));  // [point][legs]
  best.front().front().loss = 0.0;
  for (const Shortcut& shortcut : shortcuts) {
    for (std::size_t legs = 1; legs <= most; ++legs) {
      const double loss = best[shortcut.from][legs - 1].loss + shortcut.loss;
      if (loss < best[shortcut.to][legs].loss) best[shortcut.to][legs] = {loss, shortcut.from};
    }
  }
  std::size_t legs = most;
  while (legs > 0 && !std::isfinite(best.back()[legs].loss)) --legs;
  if (legs == 0) return std::nullopt;
  std::vector<std::size_t> chain{points - 1};
  for (; legs > 0; --legs) chain.push_back(best[chain.back()][legs].from);
  std::ranges::reverse(chain);
  return chain;
}

}  // namespace floeplan::planning::refinement
