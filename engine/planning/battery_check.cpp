#include "engine/planning/battery_check.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace floeplan::planning {
namespace {

std::string shortage_text(const PlanEnergy& energy) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "the plan draws %.2f MJ, %.2f MJ more than the %.2f MJ that the battery gives above its reserve",
      energy.use.total().value / 1e6, (energy.use.total() - energy.usable).value / 1e6,
      energy.usable.value / 1e6);
  return text;
}

}  // namespace

std::optional<Infeasible> check_battery(Plan& plan, const PlanRequest& request) {
  if (!plan.energy || plan.energy->use.total() <= plan.energy->usable) return std::nullopt;
  const std::string shortage = shortage_text(*plan.energy);
  if (!request.energy.require_battery) {
    plan.warnings.push_back(shortage);
    return std::nullopt;
  }
  const auto empty = std::ranges::find_if(plan.waypoints, [&](const Waypoint& waypoint) {
    return waypoint.energy.value_or(core::Joules{}) > plan.energy->usable;
  });
  return Infeasible{.reason = Reason::energy_exceeded,
                    .at = empty->place,
                    .when = empty->eta,
                    .explanation = shortage,
                    .suggestion =
                        "start with a fuller battery, save energy (--objective energy, --thruster "
                        "off, deeper dives), or plan a shorter way",
                    .binding = Constraint::battery};
}

}  // namespace floeplan::planning
