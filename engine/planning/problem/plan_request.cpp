#include "engine/planning/problem/plan_request.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::planning {
namespace {

/// Longest distance between two stops: a quarter of the globe. Beyond it one conformal plane distorts too
/// much.
constexpr double longest_leg_m = 5e6;
constexpr double shortest_leg_m = 1.0;

void require_places(messages::Faults& faults, const PlanRequest& request) {
  std::vector<std::pair<std::string, geo::LonLat>> stops{{"/from", request.from}};
  for (std::size_t i = 0; i < request.via.size(); ++i)
    stops.emplace_back("/via/" + std::to_string(i), request.via[i]);
  stops.emplace_back("/to", request.to);
  bool places_hold = true;
  for (const auto& [field, place] : stops)
    places_hold &= faults.require<"not-a-place">(geo::is_valid(place), field);
  for (std::size_t i = 1; places_hold && i < stops.size(); ++i) {
    const auto& [field, place] = stops[i];
    const double length_m = geo::geodesic_between(stops[i - 1].second, place).length.value;
    faults.require<"same-place-as-before">(length_m >= shortest_leg_m, field);
    faults.require<"leg-too-long">(length_m <= longest_leg_m, field);
  }
}

}  // namespace

Objective PlanRequest::objective() const {
  Objective result = energy.objective;
  result.of_encounters = result.of_time * icebergs.encounter_weight.count();
  return result;
}

core::Violations PlanRequest::violations() const {
  messages::Faults faults;
  faults.take(vehicle.violations());
  faults.take(energy.violations(vehicle));
  require_places(faults, *this);
  faults.require<"not-a-time">(std::isfinite(core::unix_seconds(depart)), "/depart");
  faults.take(departures.violations(depart));
  faults.require<"order-in-window">(!(via_in_best_order && departures.until), "/via_order");
  faults.require<"unknown-neighbourhood">(sectors >= 1 && sectors <= 5, "/sectors");
  const auto is_spacing = [](const std::optional<core::Metres>& spacing) {
    return !spacing || (spacing->value >= 1.0 && spacing->value <= 100'000.0);
  };
  faults.require<"not-between">(is_spacing(spacing_along) && is_spacing(spacing_across), "/spacing_m", "1 m",
                                "100 km");
  faults.within(refine_time.count(), 0.05, 60.0, "/refine_seconds", "0.05", "60");
  faults.within(leg_tolerance, 0.0, 0.1, "/leg_tolerance", "0", "0.1");
  faults.require<"unknown-number-of-alternatives">(alternatives >= 0 && alternatives <= most_alternatives,
                                                   "/alternatives");
  const bool is_one_search = !departures.until && !departures.arrive_by && method != Method::direct;
  faults.require<"alternatives-of-several">(alternatives == 0 || is_one_search, "/alternatives");
  faults.require<"not-at-least">(!max_waypoints || *max_waypoints >= 2, "/max_waypoints",
                                 "2: the start and the goal");
  if (max_leg) faults.within(max_leg->value, 100.0, 5e6, "/max_leg_m", "100 m", "5000 km");
  faults.within(holds.longest.count(), 0.0, longest_hold_allowed.count(), "/max_loiter_s", "0",
                "864000, ten days");
  faults.within(holds.radius.value, 50.0, 10'000.0, "/hold_radius_m", "50 m", "10 km");
  for (std::size_t i = 0; i < zones.size(); ++i)
    faults.take(zones[i].violations(), "/zones/" + std::to_string(i));
  faults.take(uncertainty.violations(), "/uncertainty");
  faults.within(edge_tolerance, 1e-9, 1e-2, "/edge_tolerance", "1e-9", "1e-2");
  faults.require<"encounters-without-time">(
      icebergs.encounter_weight.count() == 0.0 || energy.objective.of_time > 0.0, "/encounter_weight_s");
  faults.take(icebergs.violations());
  faults.take(under_ice.violations());
  return faults.found();
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
