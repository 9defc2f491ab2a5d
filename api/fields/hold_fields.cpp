#include "api/fields/request_fields.hpp"

/// Rows of how long and how close to a place the vehicle may hold station.
namespace floeplan::fields {

using planning::PlanRequest;

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
