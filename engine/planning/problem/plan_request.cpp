#include "engine/planning/problem/plan_request.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "engine/geo/geodesic.hpp"

namespace floeplan::planning {
namespace {

/// Longest distance between two stops: a quarter of the globe, beyond which one conformal plane distorts too
/// much.
constexpr double longest_leg_m = 5e6;
constexpr double shortest_leg_m = 1.0;

}  // namespace

Objective PlanRequest::objective() const {
  Objective result = energy.objective;
  result.of_encounters = result.of_time * icebergs.encounter_weight.count();
  return result;
}

core::Violations PlanRequest::violations() const {
  core::Violations found = vehicle.violations();
  const core::Violations of_energy = energy.violations(vehicle);
  found.insert(found.end(), of_energy.begin(), of_energy.end());
  const auto require = [&](bool holds, std::string field, std::string rule) {
    if (!holds) found.push_back({std::move(field), std::move(rule)});
    return holds;
  };
  const std::string place_rule =
      "must be [longitude, latitude] in degrees, longitude -180 to 360, latitude -90 to 90, longitude first";
  bool places_hold = require(geo::is_valid(from), "/from", place_rule);
  places_hold &= require(geo::is_valid(to), "/to", place_rule);
  for (std::size_t i = 0; i < via.size(); ++i) {
    places_hold &= require(geo::is_valid(via[i]), "/via/" + std::to_string(i), place_rule);
  }
  if (places_hold) {
    geo::LonLat last = from;
    for (std::size_t i = 0; i <= via.size(); ++i) {
      const bool at_goal = i == via.size();
      const geo::LonLat next = at_goal ? to : via[i];
      const std::string field = at_goal ? "/to" : "/via/" + std::to_string(i);
      const double length_m = geo::geodesic_between(last, next).length.value;
      require(length_m >= shortest_leg_m, field, "is the same place as the one before it; choose another");
      require(length_m <= longest_leg_m, field,
              "is more than 5000 km from the place before it: plan in parts, or check the order of the two "
              "numbers; longitude comes first");
      last = next;
    }
  }
  require(std::isfinite(core::unix_seconds(depart)), "/depart", "must be a time");
  std::ranges::move(departures.violations(depart), std::back_inserter(found));
  require(
      !(via_in_best_order && departures.until), "/via_order",
      "must be \"given\" where departures are compared: plan the best order for the best of them afterwards");
  require(sectors >= 1 && sectors <= 5, "/sectors", "must be 1, 2, 3, 4 or 5");
  const auto spacing_holds = [](std::optional<core::Metres> spacing) {
    return !spacing || (spacing->value >= 1.0 && spacing->value <= 100'000.0);
  };
  require(spacing_holds(spacing_along) && spacing_holds(spacing_across), "/spacing_m",
          "must be between 1 m and 100 km");
  require(refine_time.count() >= 0.05 && refine_time.count() <= 60.0, "/refine_seconds",
          "must be between 0.05 and 60");
  require(!max_waypoints || *max_waypoints >= 2, "/max_waypoints",
          "must be at least 2: the start and the goal");
  require(!max_leg || (max_leg->value >= 100.0 && max_leg->value <= 5e6), "/max_leg_m",
          "must be between 100 m and 5000 km");
  require(holds.longest.count() >= 0.0 && holds.longest <= longest_hold_allowed, "/max_loiter_s",
          "must be between 0 and 864000, ten days");
  require(holds.radius.value >= 50.0 && holds.radius.value <= 10'000.0, "/hold_radius_m",
          "must be between 50 m and 10 km");
  for (std::size_t i = 0; i < zones.size(); ++i) {
    for (const core::Violation& violation : zones[i].violations()) {
      found.push_back({"/zones/" + std::to_string(i) + violation.field, violation.rule});
    }
  }
  for (const core::Violation& violation : uncertainty.violations()) {
    found.push_back({"/uncertainty" + violation.field, violation.rule});
  }
  require(edge_tolerance >= 1e-9 && edge_tolerance <= 1e-2, "/edge_tolerance",
          "must be between 1e-9 and 1e-2");
  require(icebergs.encounter_weight.count() == 0.0 || energy.objective.of_time > 0.0, "/encounter_weight_s",
          "must be 0 where time has no weight: seconds then tell nothing of what an encounter counts");
  const core::Violations of_icebergs = icebergs.violations();
  found.insert(found.end(), of_icebergs.begin(), of_icebergs.end());
  for (core::Violation& violation : under_ice.violations()) found.push_back(std::move(violation));
  return found;
}

PlanRequest leaving_at(const PlanRequest& request, core::UtcTime depart) {
  PlanRequest result = request;
  result.depart = depart;
  result.departures = {};
  return result;
}

void throw_if_invalid(const PlanRequest& request) {
  const core::Violations violations = request.violations();
  if (!violations.empty())
    throw std::invalid_argument{violations.front().field + ' ' + violations.front().rule};
}

}  // namespace floeplan::planning
