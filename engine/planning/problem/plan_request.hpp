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

/// Which search finds the route. All of them are re-costed by the same edge integration.
enum class Method {
  tve,       // label-correcting, as the paper's Table I prints it
  dijkstra,  // label-setting on arrival times
  astar,     // the same with a bound on the remaining time
  frozen,    // the paper's left column: weights fixed at departure
  direct     // the straight line
};

[[nodiscard]] std::string method_name(Method method);
[[nodiscard]] std::optional<Method> parse_method(std::string_view name);

/// More than a pilot would compare.
inline constexpr int most_alternatives = 3;

/// What to plan, apart from the data to plan it in.
struct PlanRequest {
  geo::LonLat from;
  geo::LonLat to;
  std::vector<geo::LonLat> via;   // to be visited in this order, unless
  bool via_in_best_order{false};  // in the order that reaches the goal earliest
  core::UtcTime depart;
  DepartureRules departures;
  vehicle::GliderProfile vehicle;
  vehicle::FlightChoices flight;  // what is asked for whatever the vehicle; `vehicle` has it already
  EnergyRules energy;

  std::optional<core::Metres>
      spacing_along;  // of the grid, towards the goal; default distance/200 in 250 m .. 5 km
  std::optional<core::Metres> spacing_across;  // default the same as along
  int sectors{3};                              // reach of the grid's edges, 1 to 5
  /// How far ways are looked for on every side, however near the stops are to each other; empty: as usual. For who
  /// plans a request again where currents carry the vehicle far round.
  std::optional<core::Metres> room{};
  Method method{Method::astar};
  bool refine{true};
  core::Seconds refine_time{1.0};    // worth of legs that refinement may time: refinement_budget.hpp
  bool optimality_gap{true};         // compare the plan with the best way in open water
  double leg_tolerance{0.005};       // share of its cost that refinement may give for fewer and longer legs
  int alternatives{0};               // to the plan, which `find_alternatives` looks for; 0 to 3
  std::optional<int> max_waypoints;  // start and goal included
  std::optional<core::Metres> max_leg;  // longer legs are parted
  HoldRules holds;
  std::vector<ocean::Zone> zones;  // obeyed beside those of the environment
  IcebergRules icebergs;
  UncertaintyRules uncertainty;
  UnderIceRules under_ice;      // where there is sea ice
  double edge_tolerance{1e-4};  // relative, of an edge's travel time

  /// What the best plan has least of, with the weight of encounters.
  [[nodiscard]] Objective objective() const;
  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The same for one departure, without a window or a wanted arrival.
[[nodiscard]] PlanRequest leaving_at(const PlanRequest& request, core::UtcTime depart);

/// Throws std::invalid_argument that names the first violation, if there is one.
void throw_if_invalid(const PlanRequest& request);

}  // namespace floeplan::planning
