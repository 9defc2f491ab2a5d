#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::planning {

std::optional<core::Metres> length_below_ice(const SurfacingPlan& plan) {
  if (!plan.below_ice) return std::nullopt;
  core::Metres all{0.0};
  for (const StretchBelowIce& stretch : *plan.below_ice) all = all + stretch.length;
  return all;
}

std::optional<core::Seconds> time_below_ice(const SurfacingPlan& plan) {
  if (!plan.below_ice) return std::nullopt;
  core::Seconds all{0.0};
  for (const StretchBelowIce& stretch : *plan.below_ice) all += stretch.time;
  return all;
}

}  // namespace floeplan::planning
