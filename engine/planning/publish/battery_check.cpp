#include "engine/planning/publish/battery_check.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace floeplan::planning::publish {
namespace {

std::string shortage_text(const PlanEnergy& energy) {
  char text[160];
  if (energy.usable.value < 0.0) {
    std::snprintf(text, sizeof text,
                  "the plan draws %.2f MJ, and the battery begins %.2f MJ below its reserve",
                  energy.use.total().value / 1e6, -energy.usable.value / 1e6);
    return text;
  }
  std::snprintf(
      text, sizeof text,
      "the plan draws %.2f MJ, %.2f MJ more than the %.2f MJ that the battery gives above its reserve",
      energy.use.total().value / 1e6, (energy.use.total() - energy.usable).value / 1e6,
      energy.usable.value / 1e6);
  return text;
}

std::string escape_text(std::size_t waypoint, core::Joules needed, core::Joules left) {
  char text[200];
  std::snprintf(text, sizeof text,
                "the way to open water from waypoint %zu draws %.2f MJ, but %.2f MJ are left there above the "
                "battery's reserve",
                waypoint, needed.value / 1e6, std::max(left.value, 0.0) / 1e6);
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

std::optional<Infeasible> check_escapes(Plan& plan, const PlanRequest& request) {
  const std::vector<EscapeWay>& escapes = plan.surfacing->escapes;
  for (std::size_t i = 0; i < escapes.size(); ++i) {
    const Waypoint& waypoint = plan.waypoints[i];
    const core::Joules left = plan.energy->usable - waypoint.energy.value_or(core::Joules{});
    if (escapes[i].energy <= left || escapes[i].time.count() == 0.0) continue;
    const std::string shortage = escape_text(i, escapes[i].energy, left);
    if (!request.energy.require_battery) {
      plan.warnings.push_back(shortage);
      return std::nullopt;
    }
    return Infeasible{.reason = Reason::energy_exceeded,
                      .at = waypoint.place,
                      .when = waypoint.eta,
                      .explanation = shortage,
                      .suggestion =
                          "start with a fuller battery, plan a way nearer to open water, or plan "
                          "without --escape-plan",
                      .binding = Constraint::battery};
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::publish
