#pragma once

#include <cstddef>
#include <vector>

#include "engine/motion/disc_encounter.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// Calls `visit(leg, move)` for all holds and legs of the vehicle, as moves at constant speed, in order of
/// time.
/// `drives` one for each leg
template <class Visit>
void for_each_move(const cost::Sea& sea, const std::vector<geo::PlanePoint>& route,
                   const cost::Schedule& schedule, const std::vector<vehicle::Drive>& drives, Visit&& visit) {
  for (std::size_t i = 1; i < route.size(); ++i) {
    const core::Seconds leaves = schedule.leaves(i - 1);
    if (schedule.waits[i - 1].count() > 0.0) {
      visit(i,
            motion::EvenMove{route[i - 1], route[i - 1], schedule.arrivals[i - 1].count(), leaves.count()});
    }
    for (const motion::EvenMove& move : sea.drive(route[i - 1], route[i], leaves, drives[i - 1]))
      visit(i, move);
  }
}

}  // namespace floeplan::planning::publish
