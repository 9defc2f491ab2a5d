#include "engine/planning/diagnosis/relaxation.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace floeplan::planning::diagnosis {
namespace {

/// How long after the vehicle's arrival at the zone that stopped the search this zone ends; empty if no end
/// is known.
std::optional<core::Seconds> until_a_zone_ends(const ocean::Environment& environment,
                                               const PlanRequest& request, const Infeasible& why) {
  if (why.binding != Constraint::zone) return std::nullopt;
  std::optional<core::Seconds> soonest;
  for (const auto* zones : {&request.zones, &environment.zones}) {
    for (const ocean::Zone& zone : *zones) {
      if (!zone.until || *zone.until <= why.when) continue;
      const core::Seconds delay = *zone.until - why.when;
      soonest = std::min(soonest.value_or(delay), delay);
    }
  }
  return soonest;
}

/// Whether some zone closes after the departure, so that a faster vehicle may pass before.
bool may_be_passed_in_time(const ocean::Environment& environment, const PlanRequest& request) {
  const auto closes_later = [&](const ocean::Zone& zone) {
    const auto& closes = zone.kind == ocean::ZoneKind::stay_in && zone.until ? zone.until : zone.from;
    return closes && *closes > request.depart;
  };
  return std::ranges::any_of(request.zones, closes_later) ||
         std::ranges::any_of(environment.zones, closes_later);
}

}  // namespace

geo::LonLat& stop_named(PlanRequest& request, const std::string& input) {
  if (input == "from") return request.from;
  if (input == "to") return request.to;
  return request.via.at(std::stoul(input.substr(input.find('/') + 1)));
}

FoundChanges find_changes(const ocean::Environment& environment, const PlanRequest& request,
                          const Infeasible& why, const Trial& trial, const std::stop_token& stop,
                          const Trial& without_stored_zones) {
  InputChanges inputs{environment, request, trial, stop};
  inputs.allow_holds();
  if (const auto delay = why.postponed ? why.postponed : until_a_zone_ends(environment, request, why))
    inputs.depart_after(*delay);
  for (const Change& move : why.changes) inputs.take_move(move);
  switch (why.binding) {
    case Constraint::current:
      inputs.use_the_thruster();
      inputs.raise_speed();
      inputs.raise_the_thrusters_speed();
      inputs.depart_later();
      break;
    case Constraint::data_period:
      inputs.use_the_thruster();
      inputs.raise_speed();
      inputs.raise_the_thrusters_speed();
      break;
    case Constraint::iceberg:
      inputs.shrink_margin();
      inputs.allow_for_less_error();
      if (request.icebergs.pass_under) inputs.dive_deeper();
      if (!why.at_a_stop) inputs.refine_the_grid();
      if (!why.postponed) inputs.depart_later();
      break;
    case Constraint::ice:
      inputs.stay_longer_under_ice();
      inputs.keep_less_from_ice();
      inputs.dive_deeper();
      inputs.keep_less_above_the_bed();
      inputs.depart_later();
      break;
    case Constraint::zone:
      inputs.leave_out_zones();
      inputs.leave_out_stored_zones(without_stored_zones);
      inputs.dive_less_deep();
      if (may_be_passed_in_time(environment, request)) {
        inputs.use_the_thruster();
        inputs.raise_speed();
        inputs.raise_the_thrusters_speed();
      }
      if (!why.at_a_stop) inputs.refine_the_grid();
      break;
    case Constraint::depth:
      inputs.keep_less_above_the_bed();
      inputs.work_in_shallower_water();
      inputs.climb_higher();
      inputs.take_another_vehicle();
      if (!why.at_a_stop) inputs.refine_the_grid();
      break;
    case Constraint::land:
      if (!why.at_a_stop) inputs.refine_the_grid();
      break;
    case Constraint::battery:
      inputs.charge_the_battery();
      inputs.leave_the_thruster_off();
      inputs.take_a_larger_battery();
      break;
    case Constraint::data_area:
      if (!why.at_a_stop) inputs.depart_later();
      break;
    case Constraint::memory:
    case Constraint::caller: break;
  }
  return std::move(inputs).found();
}

}  // namespace floeplan::planning::diagnosis
