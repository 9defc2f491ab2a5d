#pragma once

#include <cstddef>
#include <vector>

#include "engine/ocean/grids/axis.hpp"

namespace floeplan::ocean {

/// `count` nodes from `first`, `step` apart.
inline Axis even_axis(double first, double step, std::size_t count) {
  std::vector<double> nodes(count);
  for (std::size_t i = 0; i < count; ++i) nodes[i] = first + step * static_cast<double>(i);
  return Axis{nodes};
}

}  // namespace floeplan::ocean
