#include "engine/planning/search/waiting/voyage.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::search {

Voyage::Voyage(const cost::Sea& sea, const cost::RouteGrid& grid, const Openings& openings,
               core::Seconds latest, ArrivalLadder* ladder)
    : sea_{sea},
      grid_{grid},
      openings_{openings},
      goal_{grid.point(grid.goal)},
      latest_s_{latest.count()},
      ladder_{ladder},
      earliest_s_(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny), INFINITY) {
  span_s_ = (grid.shortest_step() / sea.through_water()).count();
}

double Voyage::opens_s(double when_s) const {
  for (const TimeSpan& closed : openings_.closed(grid_.goal)) {
    if (closed.from.count() < when_s && when_s < closed.until.count()) return closed.until.count();
  }
  return when_s;
}

bool Voyage::dominates(graph::Vertex v, const graph::Label<State>& a, const graph::Label<State>& b) const {
  const bool no_worse = a.arrival_s <= b.arrival_s && a.state.energy_j <= b.state.energy_j &&
                        a.state.since_surfacing_s <= b.state.since_surfacing_s &&
                        a.state.interval == b.state.interval;
  if (!no_worse || !openings_.matter(v, b.arrival_s)) return no_worse;
  return std::floor(a.arrival_s / span_s_) == std::floor(b.arrival_s / span_s_);
}

}  // namespace floeplan::planning::search
