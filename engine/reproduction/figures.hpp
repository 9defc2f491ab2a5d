#pragma once

#include <vector>

#include "engine/reproduction/figure.hpp"

namespace floeplan::reproduction {

inline constexpr int first_figure = 5;
inline constexpr int last_figure = 10;

/// Figures 5 to 10 of the paper from our own searches. Those of the jet show the stand-in of `jet_cases`, the
/// last one the obstacles of `jet_obstacles`.
/// Source   Eichhorn 2009, Figures 5 to 10
[[nodiscard]] std::vector<Figure> reproduce_figures();

}  // namespace floeplan::reproduction
