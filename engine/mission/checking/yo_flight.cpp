#include "engine/mission/checking/yo_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/document/thruster_yo.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::mission {
namespace {

YoDives yo_of(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  return {climb_target(plan, vehicle), target_depth(vehicle), thruster_of_yo(plan, vehicle).has_value()};
}

bool has_leg_on_thruster(const planning::Plan& plan) {
  return std::ranges::any_of(plan.waypoints, [](const planning::Waypoint& waypoint) {
    return waypoint.drive == vehicle::Drive::thruster;
  });
}

/// Whether the yo runs without thruster although the plan has legs with it.
bool leaves_thruster_off(const planning::Plan& plan, const YoDives& yo) {
  return !yo.on_thruster && has_leg_on_thruster(plan);
}

/// Text such as "which turns between 90 m and 196 m on the whole route and leaves the thruster off".
std::string text_of(const planning::Plan& plan, const YoDives& yo) {
  return "which turns between " + whole(yo.climb_to.value) + " m and " + whole(yo.dive_depth.value) +
         " m on the whole route" + (leaves_thruster_off(plan, yo) ? " and leaves the thruster off" : "");
}

/// How to get a plan that one yo flies exactly as planned.
std::string way_out(const planning::Plan& plan, const vehicle::GliderProfile& vehicle, const YoDives& yo) {
  std::vector<std::string> changes;
  if (yo.climb_to > vehicle.climb_to)
    changes.push_back("an upper turn at " + whole(yo.climb_to.value) + " m (--climb-to " +
                      whole(yo.climb_to.value) + ")");
  if (yo.dive_depth < core::Metres{std::floor(vehicle.dive_depth.value)})
    changes.push_back("a dive depth of " + whole(yo.dive_depth.value) + " m (--dive-depth " +
                      whole(yo.dive_depth.value) + ")");
  if (leaves_thruster_off(plan, yo))
    changes.emplace_back("the thruster on all legs (--thruster on) or on none (--thruster off)");
  std::string text = "plan again";
  for (std::size_t i = 0; i < changes.size(); ++i) text += (i == 0 ? " with " : " and ") + changes[i];
  return text;
}

/// Text for the pilot if times or battery differ from the plan; empty if they hardly do.
std::string difference(const planning::Plan& plan, const planning::Plan& flown) {
  // Judgements: differences within the uncertainty of current forecasts.
  constexpr double same_time = 0.01;
  constexpr double same_energy = 0.05;
  const core::Seconds later = flown.arrival - plan.arrival;
  const bool is_timed = std::abs(later.count()) > same_time * plan.travel_time().count();
  const double planned_j = plan.energy ? plan.energy->use.total().value : 0.0;
  const double drawn_j = flown.energy ? flown.energy->use.total().value : 0.0;
  const bool is_drawn = planned_j > 0.0 && std::abs(drawn_j - planned_j) > same_energy * planned_j;
  if (!is_timed && !is_drawn) return "";
  const std::string arrival =
      is_timed ? "arrives at " + core::iso8601(flown.arrival) + ", " +
                     core::hours_minutes(core::Seconds{std::abs(later.count())}) +
                     (later.count() < 0.0 ? " earlier" : " later") + " than planned, and "
               : "";
  char text[160];
  std::snprintf(text, sizeof text, "the vehicle %sdraws %.2f MJ instead of %.2f MJ", arrival.c_str(),
                drawn_j / 1e6, planned_j / 1e6);
  return text;
}

/// Whether the battery suffices for the plan. If so it must also suffice for the flight: below ice an empty
/// vehicle is lost.
bool battery_carries(const planning::Plan& plan) {
  return plan.energy && plan.energy->use.total() <= plan.energy->usable;
}

}  // namespace

planning::PlanRequest flown_with(planning::PlanRequest request, const YoDives& yo) {
  vehicle::GliderProfile& vehicle = request.vehicle;
  const core::Metres deepest = std::min(yo.dive_depth, vehicle.depth_rating);
  if (deepest >= yo.climb_to + vehicle::lowest_tooth && yo.climb_to.value >= 0.0) {
    vehicle.dive_depth = deepest;
    vehicle.climb_to = yo.climb_to;
  }
  if (vehicle.thruster) {
    request.energy.thruster = yo.on_thruster ? planning::ThrusterUse::on : planning::ThrusterUse::off;
  }
  return request;
}

bool flies_otherwise(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  constexpr double nearly = 0.9;  // of the depth: the target of a shallow vehicle is a tenth above its rating
  const YoDives yo = yo_of(plan, vehicle);
  return least_upper_turn(plan) > vehicle.climb_to || yo.dive_depth < nearly * vehicle.dive_depth ||
         leaves_thruster_off(plan, yo);
}

YoFlight fly_by_yo(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                   const planning::PlanRequest& request, const planning::Plan& plan) {
  const YoDives yo = yo_of(plan, request.vehicle);
  planning::PlanRequest flown = planning::leaving_at(flown_with(request, yo), plan.departure);
  flown.energy.require_battery = battery_carries(plan);
  const RouteCheck check = check_route(environment, route, flown);

  YoFlight result;
  const std::string flyer = "by the one yo of the mission, " + text_of(plan, yo);
  const std::string instead = way_out(plan, request.vehicle, yo);
  for (const RouteFinding& finding : check.findings) {
    const std::string text =
        flyer + ". Before waypoint " + std::to_string(finding.place) + ", " + finding.text;
    if (finding.dangerous)
      result.violations.push_back(messages::mission_fault<"not-flown-by-yo">("/waypoints", text, instead));
    else
      result.messages.push_back(messages::export_message<"yo-may-not-fly-plan">(text));
  }
  if (!check.timing) return result;
  if (const std::string other = difference(plan, *check.timing); !other.empty())
    result.messages.push_back(messages::export_message<"yo-flies-otherwise">(flyer, other, instead));
  return result;
}

}  // namespace floeplan::mission
