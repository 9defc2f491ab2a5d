#include "api/fields/request_fields.hpp"

/// Rows of how to search, for what, and where to hold.
namespace floeplan::fields {
namespace {

using planning::EnergyRules;
using planning::Method;
using planning::Objective;
using planning::PlanRequest;
using planning::ThrusterUse;

constexpr double heaviest = 1e6;

}  // namespace

const std::vector<Field>& grid_fields() {
  static const std::vector<Field> list{
      {.name = "spacing_m",
       .flag = "spacing",
       .group = group::search,
       .help = "Spacing of the search grid, metres; two numbers: along and across (default: a 200th of the "
               "distance, 250 m to 5 km)",
       .details = "By default, searches for more than the least time begin with a spacing 2.5 times as large",
       .form = {"Grid spacing", "m", "automatic"}},
  };
  return list;
}

const Table<PlanRequest>& alternative_fields() {
  static const Table<PlanRequest> table{
      bound<PlanRequest>(
          {.name = "alternatives",
           .least = 0.0,
           .most = 3.0,
           .flag = "alternatives",
           .help = "Number of other routes to look for: round the other side of an island, a "
                   "bank, a group of icebergs or a closed area",
           .details = "Each is stored as a plan of its own. Obstacles count that are at least a "
                      "twentieth of the distance across, and routes that take at most twice the "
                      "time",
           .form = {"Alternatives", {}, "0"}},
          [](auto& request) -> auto& { return request.alternatives; }),
  };
  return table;
}

const Table<PlanRequest>& search_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::search,
      {
          bound<PlanRequest>(
              {.name = "sectors",
               .least = 1.0,
               .most = 5.0,
               .flag = "sectors",
               .help = "Neighbourhood of the grid, in sectors",
               .details = "Where currents are as fast as the vehicle, grids of 5 sectors are tried, too",
               .form = {"Neighbourhood", "1–5 sectors"}},
              [](auto& request) -> auto& { return request.sectors; }),
          worded<PlanRequest>(
              {.name = "method", .flag = "method", .help = "Search algorithm", .form = {"Method"}},
              std::vector<Choice<Method>>{{{"tve"}, Method::tve},
                                          {{"dijkstra"}, Method::dijkstra},
                                          {{"astar"}, Method::astar},
                                          {{"frozen"}, Method::frozen},
                                          {{"direct"}, Method::direct}},
              [](auto& request) -> auto& { return request.method; }),
          bound<PlanRequest>({.name = "leg_tolerance",
                              .unit = "share",
                              .least = 0.0,
                              .most = 0.1,
                              .flag = "leg-tolerance",
                              .help = "How much more than the best refined route the plan may take for fewer "
                                      "and longer legs, as a share of its time or energy",
                              .details = "Legs shorter than 3 km, or a fifth of the distance where that is "
                                         "less, are left only where no other route within this share is open",
                              .form = {"Fewer legs for at most", "%"}},
                             [](auto& request) -> auto& { return request.leg_tolerance; }),
          bound<PlanRequest>({.name = "max_waypoints",
                              .least = 2.0,
                              .most = 10'000.0,
                              .flag = "max-waypoints",
                              .help = "Largest number of waypoints, start and goal included",
                              .form = {"Max. waypoints", {}, "no limit"}},
                             [](auto& request) -> auto& { return request.max_waypoints; }),
          bound<PlanRequest>({.name = "max_leg_m",
                              .unit = "m",
                              .least = 100.0,
                              .most = 5e6,
                              .flag = "max-leg",
                              .help = "Longest leg; longer legs are divided",
                              .form = {"Max. leg length", "km", "no limit"}},
                             [](auto& request) -> auto& { return request.max_leg; }),
          bound<PlanRequest>(
              {.name = "refine",
               .flag = "no-refine",
               .help = "Refine the route by moving waypoints off the grid where that lowers the cost",
               .form = {"Refine the route beyond the grid"}},
              [](auto& request) -> auto& { return request.refine; }),
          bound<PlanRequest>(
              {.name = "refine_seconds",
               .unit = "s",
               .least = 0.05,
               .most = 60.0,
               .flag = "refine-seconds",
               .help = "Limit of the work of refinement, as its time on a usual machine",
               .details =
                   "Each second allows 200000 leg computations, 30000 with energy or encounters in "
                   "the objective, half of that with a thruster. The limit counts computations and not "
                   "time: the route is the same on every machine",
               .form = {"Refine for about", "s"}},
              [](auto& request) -> auto& { return request.refine_time; }),
          bound<PlanRequest>({.name = "optimality_gap",
                              .flag = "no-optimality-gap",
                              .help = "Compare the plan with the best possible route in open water",
                              .details = "The result is optimality_gap of the plan",
                              .form = {"Compare with the best possible route"}},
                             [](auto& request) -> auto& { return request.optimality_gap; }),
      });
  return table;
}

const std::vector<Field>& objective_fields() {
  static const std::vector<Field> list{
      {.name = "objective",
       .flag = "objective",
       .group = group::vehicle,
       .help = "What to minimise: time (default), energy, or weights of a second and of a joule",
       .form = {"Optimise"}},
  };
  return list;
}

const Table<Objective>& weight_fields() {
  static const Table<Objective> table = in_group<Objective>(
      group::vehicle, without_usual<Objective>({
                          bound<Objective>({.name = "time",
                                            .object = "objective",
                                            .most = heaviest,
                                            .help = "Weight of a second",
                                            .form = {"A second weighs"}},
                                           [](auto& objective) -> auto& { return objective.of_time; }),
                          bound<Objective>({.name = "energy",
                                            .object = "objective",
                                            .most = heaviest,
                                            .help = "Weight of a joule",
                                            .form = {"A joule weighs"}},
                                           [](auto& objective) -> auto& { return objective.of_energy; }),
                      }));
  return table;
}

const Table<EnergyRules>& energy_fields() {
  static const Table<EnergyRules> table = in_group<EnergyRules>(
      group::vehicle,
      {
          worded<EnergyRules>(
              {.name = "thruster",
               .flag = "thruster",
               .help = "Use of the thruster (auto: as the objective requires)",
               .form = {"Thruster"}},
              std::vector<Choice<ThrusterUse>>{
                  {{"auto"}, ThrusterUse::automatic}, {{"on"}, ThrusterUse::on}, {{"off"}, ThrusterUse::off}},
              [](auto& rules) -> auto& { return rules.thruster; }),
          bound<EnergyRules>({.name = "require_battery",
                              .flag = "require-battery",
                              .help = "Refuse plans that need more energy than the battery gives",
                              .form = {"Only plans within the battery"}},
                             [](auto& rules) -> auto& { return rules.require_battery; }),
      });
  return table;
}

const Table<PlanRequest>& hold_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::search,
      {
          bound<PlanRequest>(
              {.name = "max_loiter_s",
               .unit = "s",
               .most = planning::longest_hold_allowed.count(),
               .flag = "max-hold",
               .former_flag = "max-loiter",
               .none_flag = "no-hold",
               .help = "Longest hold at a waypoint until an iceberg, a timed area or a current clears",
               .details =
                   "0: the vehicle never holds. A glider cannot stand still: it holds station by making way "
                   "against the current. It holds only where the current on its hold circle is known and at "
                   "most "
                   "0.8 of its speed through the water, and where nothing closes that circle; below ice the "
                   "circle "
                   "is as much wider as its dead reckoning may be wrong. A hold draws energy as if under "
                   "way. wait_s "
                   "of a waypoint is the hold between its ETA and the next leg. With an objective other than "
                   "time, "
                   "only the fastest of the compared plans hold. A hold below ice counts for "
                   "under_ice.max_time_without_surfacing_s. The vehicle holds only right before the closed "
                   "place",
               .form = {"Longest hold", "h"}},
              [](auto& request) -> auto& { return request.holds.longest; }),
          bound<PlanRequest>({.name = "hold_radius_m",
                              .unit = "m",
                              .least = 50.0,
                              .most = 10'000.0,
                              .flag = "hold-radius",
                              .help = "Radius of the circle that the vehicle keeps to while it holds",
                              .form = {"Hold circle", "m"}},
                             [](auto& request) -> auto& { return request.holds.radius; }),
      });
  return table;
}

}  // namespace floeplan::fields
