#include "engine/planning/refinement/refinement_budget.hpp"

#include <cmath>

namespace floeplan::planning::refinement {

RefinementBudget refinement_budget(const PlanRequest& request, double legs_per_second,
                                   const std::stop_token& stop, const core::SteadyClock& clock) {
  RefinementBudget budget{.most_evaluations = std::llround(legs_per_second * request.refine_time.count()),
                          .stop = stop};
  if (clock) {
    budget.out_of_time = [&clock, end = clock() + request.refine_time] { return clock() >= end; };
  }
  return budget;
}

}  // namespace floeplan::planning::refinement
