#include "engine/planning/obstacles/cell_distances.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::planning::obstacles::cell_distances_test {
namespace {

constexpr core::Metres cell{100.0};

TEST(CellDistances, AreNeverMoreThanTheWayBetweenTheNearestSidesOfTheCells) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const auto nx = static_cast<std::size_t>(support::uniform_int(rng, 1, 12));
    const auto ny = static_cast<std::size_t>(support::uniform_int(rng, 1, 12));
    std::vector<bool> marked(nx * ny);
    for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = support::uniform(rng, 0.0, 1.0) < 0.05;
    const CellDistances distances{marked, nx, cell};

    for (std::size_t i = 0; i < marked.size(); ++i) {
      double nearest_m = INFINITY;
      for (std::size_t j = 0; j < marked.size(); ++j) {
        if (!marked[j]) continue;
        const auto gap = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
        const std::size_t cells = std::max(gap(i % nx, j % nx), gap(i / nx, j / nx));
        nearest_m = std::min(nearest_m, std::max(0.0, static_cast<double>(cells) - 1.0) * cell.value);
      }
      EXPECT_EQ(distances.from(i).value, nearest_m);
    }
  });
}

TEST(CellDistances, SayNothingWhereNothingWasMeasured) { EXPECT_EQ(CellDistances{}.from(7).value, 0.0); }

}  // namespace
}  // namespace floeplan::planning::obstacles::cell_distances_test
