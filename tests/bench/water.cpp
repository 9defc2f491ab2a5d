#include "tests/bench/water.hpp"

#include <cmath>

namespace floeplan::bench {

Water::Water(int vertices)
    : cells_per_vertex{static_cast<float>(nodes - 1) / static_cast<float>(vertices - 1)} {
  constexpr double strength_m_s = 0.15;
  currents.reserve(static_cast<std::size_t>(nodes) * nodes * slices);
  for (int slice = 0; slice < slices; ++slice) {
    for (int row = 0; row < nodes; ++row) {
      for (int column = 0; column < nodes; ++column) {
        const double x = 0.31 * column - 0.05 * slice;
        const double y = 0.27 * row + 0.02 * slice;
        currents.push_back({static_cast<float>(strength_m_s * std::sin(x) * std::cos(y)),
                            static_cast<float>(-strength_m_s * std::cos(x) * std::sin(y))});
      }
    }
  }
}

}  // namespace floeplan::bench
