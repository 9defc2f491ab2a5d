#include "api/fields/request_fields.hpp"

/// Rows of the legs: how many there may be, and how long.
namespace floeplan::fields {
namespace {

using planning::PlanRequest;

}  // namespace

const Table<PlanRequest>& leg_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::search,
      {
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
      });
  return table;
}

}  // namespace floeplan::fields
