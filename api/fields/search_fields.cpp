#include "api/fields/request_fields.hpp"

/// Rows of how to search.
namespace floeplan::fields {
namespace {

using planning::Method;
using planning::PlanRequest;

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

}  // namespace floeplan::fields
