#include "engine/planning/refinement/refinement_budget.hpp"

#include <cmath>

namespace floeplan::planning::refinement {

RefinementBudget refinement_budget(const PlanRequest& request, double legs_per_second,
                                   const std::stop_token& stop) {
  return {.most_evaluations = std::llround(legs_per_second * request.refine_time.count()), .stop = stop};
}

}  // namespace floeplan::planning::refinement
