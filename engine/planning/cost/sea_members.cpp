#include "engine/planning/cost/sea_members.hpp"

#include <cstdint>
#include <memory>
#include <random>

namespace floeplan::planning::cost {

bool has_uncertain_currents(const ocean::Environment& environment, const PlanRequest& request) {
  return environment.currents && (request.uncertainty.drawn_members > 0 || environment.members.size() > 1);
}

std::size_t SeaMembers::size() const {
  return rules_.drawn_members > 0 ? static_cast<std::size_t>(rules_.drawn_members)
                                  : environment_.members.size();
}

ocean::Environment SeaMembers::environment(std::size_t member) const {
  ocean::Environment result = environment_;
  result.members.clear();
  result.drift_members.clear();
  if (rules_.drawn_members > 0) {
    std::seed_seq seeds{static_cast<std::uint32_t>(rules_.seed),
                        static_cast<std::uint32_t>(rules_.seed >> 32), static_cast<std::uint32_t>(member)};
    std::mt19937_64 rng{seeds};
    result.currents = std::make_shared<const ocean::CurrentGrid>(
        ocean::with_error(*environment_.currents, rules_.error, rng));
    // The icebergs keep the undisturbed currents: their discs already include their position errors.
    if (!result.drift_currents) result.drift_currents = environment_.currents;
  } else {
    result.currents = environment_.members[member];
    if (!environment_.drift_members.empty()) result.drift_currents = environment_.drift_members[member];
  }
  return result;
}

}  // namespace floeplan::planning::cost
