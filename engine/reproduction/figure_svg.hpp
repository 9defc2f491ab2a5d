#pragma once

#include <string>

#include "engine/reproduction/figure.hpp"

namespace floeplan::reproduction {

/// The figure as an SVG 1.1 document: axes with ticks and labels, arrows of the current with their scale,
/// obstacles, paths, start and goal, and a legend with the travel times.
[[nodiscard]] std::string figure_svg(const Figure& figure);

}  // namespace floeplan::reproduction
