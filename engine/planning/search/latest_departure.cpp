#include "engine/planning/search/latest_departure.hpp"

#include <ranges>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"

namespace floeplan::planning::search {

std::optional<core::Seconds> latest_departure(const cost::Sea& sea, const OpenGrid& open,
                                              core::Seconds arrive, core::Seconds earliest,
                                              const std::stop_token& stop) {
  const GridTravelTimeBack travel_time{sea, open.grid};
  const FavourableBound bound{FavourableGrid{sea, open}, RouteEnd::start, stop};
  const graph::Query query{
      .source = open.grid.goal, .goal = open.grid.start, .depart = -arrive, .latest = -earliest};
  const graph::SearchTree tree = graph::find_earliest_arrivals(open.graph, query, travel_time, stop, bound);
  if (tree.stopped || !tree.is_reached(open.grid.start)) return std::nullopt;
  return core::Seconds{-tree.arrival_s(open.grid.start)};
}

std::optional<core::Seconds> latest_departure(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                                              core::Seconds arrive, core::Seconds earliest,
                                              const std::stop_token& stop) {
  for (const OpenGrid& open : std::views::reverse(grids)) {
    const auto depart = latest_departure(sea, open, arrive, earliest, stop);
    if (!depart) return std::nullopt;
    arrive = *depart;
  }
  if (arrive < earliest) return std::nullopt;
  return arrive;
}

}  // namespace floeplan::planning::search
