#include "engine/planning/search/voyage_grids.hpp"

#include "engine/planning/search/surfacing/surfacing_reach.hpp"

namespace floeplan::planning::search {

std::vector<OpenGrid> open_grids(const cost::Sea& sea, const std::vector<cost::RouteGrid>& grids, int sectors,
                                 const std::stop_token& stop) {
  std::vector<OpenGrid> result;
  result.reserve(grids.size());
  for (const cost::RouteGrid& grid : grids) result.push_back(open_grid(sea.domain(), grid, sectors, stop));
  if (!sea.domain().overhead().bounds_surfacing()) return result;
  for (std::size_t i = result.size(); i-- > 1;) {
    const OpenGrid& next = result[i];
    result[i - 1].least_after_goal = core::Seconds{least_until_surfacing_s(sea, next, stop)[next.grid.start]};
  }
  return result;
}

}  // namespace floeplan::planning::search
