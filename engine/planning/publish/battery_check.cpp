#include "engine/planning/publish/battery_check.hpp"

#include <algorithm>
#include <utility>

#include "engine/messages/plan_messages.hpp"

namespace floeplan::planning::publish {
namespace {

messages::Message shortage_of(const PlanEnergy& energy) {
  const double drawn_mj = energy.use.total().value / 1e6;
  const double usable_mj = energy.usable.value / 1e6;
  if (usable_mj < 0.0) return messages::plan_message<"battery-below-reserve">(drawn_mj, -usable_mj);
  return messages::plan_message<"battery-too-small">(
      drawn_mj, (energy.use.total() - energy.usable).value / 1e6, usable_mj);
}

}  // namespace

std::optional<Infeasible> check_battery(Plan& plan, const PlanRequest& request) {
  if (!plan.energy || plan.energy->use.total() <= plan.energy->usable) return std::nullopt;
  const auto found = std::ranges::find_if(plan.waypoints, [&](const Waypoint& waypoint) {
    return waypoint.energy.value_or(core::Joules{}) > plan.energy->usable;
  });
  // The energy of the plan and the energy at its last waypoint are summed in different orders, so they may differ
  // by rounding.
  const Waypoint& empty = found == plan.waypoints.end() ? plan.waypoints.back() : *found;
  messages::Message shortage = shortage_of(*plan.energy).at(empty.place);
  if (!request.energy.require_battery) {
    plan.messages.push_back(std::move(shortage));
    return std::nullopt;
  }
  return Infeasible{.reason = Reason::energy_exceeded,
                    .at = empty.place,
                    .when = empty.eta,
                    .why = std::move(shortage),
                    .binding = Constraint::battery};
}

std::optional<Infeasible> check_escapes(Plan& plan, const PlanRequest& request) {
  const std::vector<EscapeWay>& escapes = plan.surfacing->escapes;
  for (std::size_t i = 0; i < escapes.size(); ++i) {
    const Waypoint& waypoint = plan.waypoints[i];
    const core::Joules left = plan.energy->usable - waypoint.energy.value_or(core::Joules{});
    if (escapes[i].energy <= left || escapes[i].time.count() == 0.0) continue;
    messages::Message shortage = messages::plan_message<"battery-too-small-for-escape">(
                                     i, escapes[i].energy.value / 1e6, std::max(left.value, 0.0) / 1e6)
                                     .at(waypoint.place);
    if (!request.energy.require_battery) {
      plan.messages.push_back(std::move(shortage));
      return std::nullopt;
    }
    return Infeasible{.reason = Reason::energy_exceeded,
                      .at = waypoint.place,
                      .when = waypoint.eta,
                      .why = std::move(shortage),
                      .binding = Constraint::battery};
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::publish
