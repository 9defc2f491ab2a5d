#include "engine/planning/voyage.hpp"

namespace floeplan::planning {

Voyage::Voyage(const Sea& sea, const RouteGrid& grid) : sea_{sea}, grid_{grid} {}

bool Voyage::dominates(graph::Vertex, const graph::Label<State>& a, const graph::Label<State>& b) const {
  return a.arrival_s <= b.arrival_s && a.state.energy_j <= b.state.energy_j &&
         a.state.since_surfacing_s <= b.state.since_surfacing_s && a.state.interval == b.state.interval;
}

}  // namespace floeplan::planning
