#include "engine/planning/search/bounds/favourable_grid.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::search {

std::vector<FavourableGrid::Step> FavourableGrid::steps_of(const cost::Sea& sea, const OpenGrid& open) {
  std::vector<Step> steps;
  for (const graph::Offset offset : open.graph.offsets()) {
    const double x_m = offset.dx * open.grid.along.x_m + offset.dy * open.grid.across.x_m;
    const double y_m = offset.dx * open.grid.along.y_m + offset.dy * open.grid.across.y_m;
    const double length_m = std::hypot(x_m, y_m);
    steps.push_back(
        {core::Metres{length_m}, {x_m / length_m, y_m / length_m}, sea.least_time({0.0, 0.0}, {x_m, y_m})});
  }
  return steps;
}

FavourableGrid::FavourableGrid(const cost::Sea& sea, const OpenGrid& open)
    : sea_{sea},
      open_{open},
      steps_{steps_of(sea, open)},
      longest_{*std::ranges::max_element(steps_, {}, [](const Step& step) { return step.length.value; })} {
  if (sea.domain().currents() != nullptr) envelope_.emplace(*sea.domain().currents(), longest_.length);
}

}  // namespace floeplan::planning::search
