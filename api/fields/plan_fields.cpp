#include "api/fields/limits.hpp"
#include "api/fields/request_fields.hpp"

/// Rows of where, when and how to search.
namespace floeplan::fields {
namespace {

using planning::EnergyRules;
using planning::IsochroneRequest;
using planning::Method;
using planning::Objective;
using planning::PlanRequest;
using planning::RobustObjective;
using planning::ThrusterUse;
using planning::UncertaintyRules;

constexpr double least_step_m = 10.0;
constexpr double most_step_m = 100'000.0;
constexpr double heaviest = 1e6;

constexpr std::string_view seen_from_route =
    "Route to use of GeoJSON or a file with several: its name, or its number from 1";

/// A row of the member `uncertainty`.
template <class Access>
Bound<UncertaintyRules> uncertainty(Field field, Access access) {
  field.object = "uncertainty";
  return bound<UncertaintyRules>(std::move(field), access);
}

Field route_name() {
  return {.name = "route_name", .kind = Kind::text, .flag = "route", .help = seen_from_route};
}

}  // namespace

const std::vector<Field>& way_fields() {
  static const std::vector<Field> list{
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start, [longitude, latitude] in degrees",
       .details = "A third number, the height, is ignored",
       .form = {"Start", {}, "69°10.2′N 51°21.0′W"}},
      {.name = "to",
       .kind = Kind::place,
       .flag = "to",
       .help = "Goal, [longitude, latitude] in degrees",
       .form = {"Goal"}},
      {.name = "via",
       .kind = Kind::places,
       .flag = "via",
       .group = group::places,
       .help = "Via points, in this order",
       .form = {"Via points"}},
      {.name = "goals_file",
       .flag = "goals",
       .help = "File with the places to visit, instead of via and to; without from, its first place is the "
               "start"},
      route_name(),
  };
  return list;
}

const Table<PlanRequest>& order_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::places,
      {
          worded<PlanRequest>(
              {.name = "via_order",
               .flag = "best-order",
               .flag_sets = "best",
               .help = "Order of the via points: as given, or the one that reaches the goal earliest"},
              std::vector<Choice<bool>>{{{"given"}, false}, {{"best"}, true}},
              [](auto& request) -> auto& { return request.via_in_best_order; }),
      });
  return table;
}

const std::vector<Field>& route_fields() {
  static const std::vector<Field> list{
      {.name = "route",
       .help = "The route: GeoJSON (a line, also one cut at the antimeridian, a Feature, a "
               "FeatureCollection, the "
               "legs of a plan) or an array of positions; or give plan_id"},
      {.name = "plan_id", .kind = Kind::text, .help = "Stored plan with the route"},
      {.name = "route_file", .help = "File with the route, instead of route or plan_id"},
      route_name(),
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start of a route from a file, [longitude, latitude] in degrees"},
  };
  return list;
}

const std::vector<Field>& isochrone_fields() {
  static const std::vector<Field> list{
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start of the vehicle at depart, [longitude, latitude] in degrees; or give to"},
      {.name = "to",
       .kind = Kind::place,
       .flag = "to",
       .help = "Goal to reach by arrive_by, [longitude, latitude] in degrees"},
      {.name = "arrive_by", .kind = Kind::time, .flag = "arrive-by", .help = "Latest arrival, with to"},
      {.name = "hours",
       .flag = "hours",
       .help =
           "Hours after the departure, or before the arrival; one number or several, for example 6,12,24"},
  };
  return list;
}

const Table<IsochroneRequest>& isochrone_grid_fields() {
  static const Table<IsochroneRequest> table = in_group<IsochroneRequest>(
      group::search,
      {
          bound<IsochroneRequest>({.name = "spacing_m",
                                   .unit = "m",
                                   .least = least_step_m,
                                   .most = most_step_m,
                                   .flag = "spacing",
                                   .help = "Spacing of the grid (default: a hundredth of the distance flown "
                                           "in still water, 100 m to 5 km)"},
                                  [](auto& request) -> auto& { return request.spacing; }),
          bound<IsochroneRequest>({.name = "sectors",
                                   .least = 1.0,
                                   .most = 5.0,
                                   .flag = "sectors",
                                   .help = "Neighbourhood of the grid, in sectors (default: 3, or 5 where "
                                           "currents are as fast as the vehicle)"},
                                  [](auto& request) -> auto& { return request.sectors; }),
      });
  return table;
}

const std::vector<Field>& departure_fields() {
  static const std::vector<Field> list{
      {.name = "depart",
       .kind = Kind::time,
       .flag = "depart",
       .help = "Departure, ISO 8601 with its zone, for example 2026-11-20T06:00:00Z",
       .details = "Required unless arrive_by is given",
       .form = {"Departure", "UTC", "2026-11-20 06:00"}},
  };
  return list;
}

const std::vector<Field>& window_fields() {
  static const std::vector<Field> list{
      {.name = "depart_until",
       .kind = Kind::time,
       .flag = "depart-until",
       .group = group::window,
       .help = "Last departure of a window that begins at depart; the best departure is planned",
       .form = {"Latest departure", "UTC", "one departure only"}},
      {.name = "depart_step",
       .kind = Kind::duration,
       .flag = "depart-step",
       .group = group::window,
       .help = "Time between departures of the window, ISO 8601; default PT1H",
       .example = "PT1H",
       .form = {"Every", "h"}},
      {.name = "arrive_by",
       .kind = Kind::time,
       .flag = "arrive-by",
       .group = group::window,
       .help = "Latest arrival: the plan leaves as late as possible, not before depart",
       .form = {"Latest arrival", "UTC", "any", "The plan leaves as late as possible and arrives in time."}},
  };
  return list;
}

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
               .help = "Refine the route: move waypoints off the grid where that lowers the cost",
               .form = {"Refine the route beyond the grid"}},
              [](auto& request) -> auto& { return request.refine; }),
          bound<PlanRequest>(
              {.name = "refine_seconds",
               .unit = "s",
               .least = 0.05,
               .most = 60.0,
               .flag = "refine-seconds",
               .help = "Computing time of the refinement",
               .details = "Each second allows 200000 leg computations, 30000 with energy or encounters in "
                          "the objective, half of that with a thruster. If the time runs out first, the plan "
                          "says so, and the route may differ between machines",
               .form = {"Refine for at most", "s"}},
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

const Table<UncertaintyRules>& error_model_fields() {
  static const Table<UncertaintyRules> table = in_group<UncertaintyRules>(
      group::uncertainty,
      without_usual<UncertaintyRules>({
          uncertainty({.name = "members",
                       .least = 2.0,
                       .most = 64.0,
                       .flag = "members",
                       .help = "Number of random errors of the currents to draw; the plan shows the spread",
                       .form = {"Members", "2–64", "none"}},
                      [](auto& rules) -> auto& { return rules.drawn_members; }),
          uncertainty({.name = "current_error_m_s",
                       .unit = "m/s",
                       .least = 1e-3,
                       .most = 2.0,
                       .flag = "current-error",
                       .help = "Standard deviation of each component's error",
                       .form = {"Error of each component", "m/s"}},
                      [](auto& rules) -> auto& { return rules.error.standard_deviation; }),
          uncertainty({.name = "length_scale_m",
                       .unit = "m",
                       .least = 1e3,
                       .most = 1e6,
                       .flag = "error-length",
                       .help = "Correlation length of the error",
                       .form = {"Correlation length", "km"}},
                      [](auto& rules) -> auto& { return rules.error.length_scale; }),
          uncertainty({.name = "time_scale_s",
                       .unit = "s",
                       .least = 600.0,
                       .most = 2'592'000.0,
                       .flag = "error-time",
                       .help = "Correlation time of the error",
                       .form = {"Correlation time", "h"}},
                      [](auto& rules) -> auto& { return rules.error.time_scale; }),
          uncertainty({.name = "seed",
                       .most = largest_seed,
                       .help = "Seed of the random errors; default 1",
                       .form = {"Seed", {}, "1"}},
                      [](auto& rules) -> auto& { return rules.seed; }),
      }));
  return table;
}

const Table<UncertaintyRules>& robustness_fields() {
  static const Table<UncertaintyRules> table = in_group<UncertaintyRules>(
      group::uncertainty,
      {
          worded<UncertaintyRules>(
              {.name = "objective",
               .object = "uncertainty",
               .flag = "robust",
               .help = "Statistic of the cost over all members that the route minimises; if omitted, the "
                       "first member alone counts",
               .form = {"Plan for"}},
              std::vector<Choice<RobustObjective>>{{{"mean"}, RobustObjective::mean},
                                                   {{"quantile"}, RobustObjective::quantile}},
              [](auto& rules) -> auto& { return rules.objective; }),
          uncertainty(
              {.name = "quantile",
               .unit = "share",
               .least = 0.01,
               .most = 0.99,
               .help =
                   "Share of members that arrive by the planned time; only with the objective \"quantile\"",
               .form = {"Quantile", "%"}},
              [](auto& rules) -> auto& { return rules.quantile; }),
          uncertainty({.name = "arrive_before",
                       .flag = "arrive-before",
                       .help = "Show the chance of arriving by this time",
                       .form = {"Chance to arrive before", "UTC", "not asked"}},
                      [](auto& rules) -> auto& { return rules.arrive_before; }),
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

const std::vector<Field>& area_fields() {
  static const std::vector<Field> list{
      {.name = "areas",
       .flag = "areas",
       .group = group::places,
       .help = "Areas to keep out of or to stay in: GeoJSON polygons with the properties kind (no_go, "
               "stay_in), from, "
               "until, top_m, bottom_m"},
  };
  return list;
}

const std::vector<Field>& name_fields() {
  static const std::vector<Field> list{
      {.name = "name",
       .kind = Kind::text,
       .flag = "name",
       .group = group::search,
       .help = "Name of the result",
       .form = {"Name of the plan", {}, "optional"}},
  };
  return list;
}

const std::vector<Field>& remark_fields() {
  static const std::vector<Field> list{
      {.name = "remarks",
       .help = "Sentences to add to the warnings of the answer, for example of a program that read the "
               "places from a file"},
  };
  return list;
}

}  // namespace floeplan::fields
