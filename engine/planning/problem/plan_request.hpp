#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/zone.hpp"
#include "engine/planning/problem/departure_rules.hpp"
#include "engine/planning/problem/hold_rules.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/planning/problem/uncertainty_rules.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/vehicle/flight_choices.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning {

/// The search method. Its route is timed again by the same edge integration, whichever method found it.
enum class Method {
  tve,       // label-correcting, as the paper's Table I prints it
  dijkstra,  // label-setting on arrival times
  astar,     // label-setting with a lower bound on the remaining time
  frozen,    // the paper's left column: every edge has its travel time of the departure
  direct     // the straight line
};

[[nodiscard]] std::string method_name(Method method);
[[nodiscard]] std::optional<Method> parse_method(std::string_view name);

/// Largest number of alternatives: a pilot hardly compares more. A judgement.
inline constexpr int most_alternatives = 3;

/// What to plan. The data (currents, depths, ice) are in the environment.
struct PlanRequest {
  geo::LonLat from;
  geo::LonLat to;
  std::vector<geo::LonLat> via;   // via points, visited in this order unless the next member is true
  bool via_in_best_order{false};  // visit them in the order that reaches the goal earliest
  core::UtcTime depart;
  DepartureRules departures;
  vehicle::GliderProfile vehicle;
  vehicle::FlightChoices flight;  // choices for any vehicle; `vehicle` already includes them
  EnergyRules energy;

  std::optional<core::Metres>
      spacing_along;  // grid spacing along the line to the goal; default distance/200, 250 m to 5 km
  std::optional<core::Metres> spacing_across;  // default: as spacing_along
  int sectors{3};                              // neighbourhood of the grid, 1 to 5
  /// Width of the search area on every side, whatever the distance between stops; empty: the default. Set
  /// when a request is planned again because currents lead the route far round.
  std::optional<core::Metres> room{};
  Method method{Method::astar};
  bool refine{true};
  core::Seconds refine_time{1.0};       // limit on refinement, as work: see refinement_budget.hpp
  bool optimality_gap{true};            // compare the plan with the fastest route in open water
  double leg_tolerance{0.005};          // share of the cost that refinement may add for fewer, longer legs
  int alternatives{0};                  // number that `find_alternatives` looks for, 0 to 3
  std::optional<int> max_waypoints;     // start and goal included
  std::optional<core::Metres> max_leg;  // longer legs are divided
  HoldRules holds;
  std::vector<ocean::Zone> zones;  // obeyed in addition to those of the environment
  IcebergRules icebergs;
  UncertaintyRules uncertainty;
  UnderIceRules under_ice;      // rules below sea ice
  double edge_tolerance{1e-4};  // relative tolerance of an edge's travel time

  /// The objective of the energy rules, with the weight of encounters.
  [[nodiscard]] Objective objective() const;
  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The request for a departure at `depart`, without a window or a wanted arrival.
[[nodiscard]] PlanRequest leaving_at(const PlanRequest& request, core::UtcTime depart);

/// Throws std::invalid_argument that names the first violation, if there is one.
void throw_if_invalid(const PlanRequest& request);

}  // namespace floeplan::planning
