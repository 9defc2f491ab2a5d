#include "engine/planning/diagnosis/paired_changes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/planning/diagnosis/input_changes.hpp"
#include "engine/planning/diagnosis/relaxation.hpp"

namespace floeplan::planning::diagnosis {
namespace {

/// All inputs of a request that can help against one constraint.
struct Inputs {
  Constraint against;
  bool (*may_help)(const ocean::Environment&, const PlanRequest&);
  void (*open)(PlanRequest&);                         // gives them their most generous values
  void (*take)(PlanRequest&, const PlanRequest& of);  // copies them from another request
};

bool has_areas(const ocean::Environment&, const PlanRequest& request) { return !request.zones.empty(); }
void leave_out_areas(PlanRequest& request) { request.zones.clear(); }
void take_areas(PlanRequest& request, const PlanRequest& of) { request.zones = of.zones; }

bool has_depths_to_spare(const ocean::Environment& environment, const PlanRequest& request) {
  const auto profile = vehicle::find_profile(request.vehicle.name);
  return environment.bathymetry && profile &&
         (request.vehicle.altimeter_margin > profile->altimeter_margin ||
          request.vehicle.minimum_working_depth > profile->minimum_working_depth ||
          request.vehicle.climb_to > profile->climb_to);
}
void come_nearer_to_the_bed(PlanRequest& request) {
  const auto profile = vehicle::find_profile(request.vehicle.name);
  const auto no_more = [](core::Metres& depth, core::Metres usual) { depth = std::min(depth, usual); };
  no_more(request.vehicle.altimeter_margin, profile->altimeter_margin);
  no_more(request.vehicle.minimum_working_depth, profile->minimum_working_depth);
  no_more(request.vehicle.climb_to, profile->climb_to);
}
void take_depths(PlanRequest& request, const PlanRequest& of) {
  request.vehicle.altimeter_margin = of.vehicle.altimeter_margin;
  request.vehicle.minimum_working_depth = of.vehicle.minimum_working_depth;
  request.vehicle.climb_to = of.vehicle.climb_to;
}

bool has_margin_of_icebergs(const ocean::Environment& environment, const PlanRequest& request) {
  return !environment.icebergs.empty() && request.icebergs.margin.value > 0.0;
}
void come_nearer_to_icebergs(PlanRequest& request) { request.icebergs.margin = core::Metres{0.0}; }
void take_margin(PlanRequest& request, const PlanRequest& of) {
  request.icebergs.margin = of.icebergs.margin;
}

bool has_rules_of_ice(const ocean::Environment& environment, const PlanRequest& request) {
  const UnderIceRules& rules = request.under_ice;
  return environment.ice && (rules.max_time_without_surfacing || rules.margin_below_ice.value > 0.0);
}
void come_nearer_to_ice(PlanRequest& request) {
  request.under_ice.max_time_without_surfacing.reset();
  request.under_ice.margin_below_ice = core::Metres{0.0};
}
void take_ice(PlanRequest& request, const PlanRequest& of) {
  request.under_ice.max_time_without_surfacing = of.under_ice.max_time_without_surfacing;
  request.under_ice.margin_below_ice = of.under_ice.margin_below_ice;
}

bool has_currents(const ocean::Environment& environment, const PlanRequest&) {
  return environment.currents != nullptr;
}
void go_faster(PlanRequest& request) {
  request.vehicle.speed_through_water = fastest_tried(request.vehicle.speed_through_water);
}
void take_speed(PlanRequest& request, const PlanRequest& of) {
  request.vehicle.speed_through_water = of.vehicle.speed_through_water;
}

bool needs_its_battery(const ocean::Environment&, const PlanRequest& request) {
  return request.energy.require_battery;
}
void take_any_battery(PlanRequest& request) { request.energy.require_battery = false; }
void require_battery(PlanRequest& request, const PlanRequest& of) {
  request.energy.require_battery = of.energy.require_battery;
}

constexpr std::array all_inputs{
    Inputs{Constraint::zone, has_areas, leave_out_areas, take_areas},
    Inputs{Constraint::depth, has_depths_to_spare, come_nearer_to_the_bed, take_depths},
    Inputs{Constraint::iceberg, has_margin_of_icebergs, come_nearer_to_icebergs, take_margin},
    Inputs{Constraint::ice, has_rules_of_ice, come_nearer_to_ice, take_ice},
    Inputs{Constraint::current, has_currents, go_faster, take_speed},
    Inputs{Constraint::battery, needs_its_battery, take_any_battery, require_battery}};

bool is_speed(const Change& change) { return change.input == "speed_m_s"; }

/// `why` with another constraint. All other details are left out, because they are unknown for this
/// constraint.
Infeasible bound_by(Constraint binding, const Infeasible& why) {
  return {.reason = why.reason, .at = why.at, .when = why.when, .binding = binding};
}

}  // namespace

std::optional<Change> change_with_another(const ocean::Environment& environment, const PlanRequest& request,
                                          const Infeasible& why, const Trial& trial,
                                          const std::stop_token& stop) {
  const auto changes_against = [&](Constraint binding, const PlanRequest& of) {
    return find_changes(environment, of, bound_by(binding, why), trial, stop);
  };
  for (const Inputs& others : all_inputs) {
    if (others.against == why.binding || !others.may_help(environment, request)) continue;
    PlanRequest opened = request;
    others.open(opened);
    FoundChanges first = changes_against(why.binding, opened);
    if (first.changes.empty() || !first.changed) continue;
    PlanRequest changed = *std::move(first.changed);
    others.take(changed, request);
    // A change of the speed is one of the inputs that were just copied back, so it is lost and cannot be combined.
    if (others.against == Constraint::current && is_speed(first.changes.front())) continue;
    FoundChanges second = changes_against(others.against, changed);
    if (stop.stop_requested()) return std::nullopt;
    if (second.changes.empty() || second.changes.front().input == first.changes.front().input) continue;
    Change both = std::move(second.changes.front());
    both.text += ", and " + first.changes.front().text;
    both.with.push_back(std::move(first.changes.front()));
    return both;
  }
  return std::nullopt;
}

}  // namespace floeplan::planning::diagnosis
