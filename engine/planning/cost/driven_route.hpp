#pragma once

#include <cstddef>
#include <stop_token>
#include <tl/expected.hpp>
#include <vector>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/energy_use.hpp"
#include "engine/planning/problem/objective.hpp"

namespace floeplan::planning::cost {

/// A route with the propulsion of each leg.
struct DrivenRoute {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;             // true for start, goal and via points
  std::vector<vehicle::Drive> drives;  // one for each leg
};

/// When the vehicle is at each point, and its total energy.
struct DrivenTimes {
  std::vector<core::Seconds> arrivals;  // one for each point; the departure is the first
  EnergyUse energy;
  double encounters{};              // expected, with icebergs; zero if the objective does not weigh them
  core::Seconds since_surfacing{};  // at the last point, for a route without holds

  [[nodiscard]] double cost(const Objective& objective) const {
    return objective.cost(arrivals.back() - arrivals.front(), energy.total(), encounters);
  }
};

/// Times of a route without holds. The request's limit on the time without surfacing applies.
/// `depart` counts from the departure of the request. `since_surfacing`: at the first point.
/// Errors   why the route is closed
[[nodiscard]] tl::expected<DrivenTimes, motion::EdgeClosed> drive_along(
    const Sea& sea, const DrivenRoute& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0}, Dives dives = Dives::over_bed);

/// Times of a route with holds where the request allows them and they make the arrival possible or earlier.
/// Every leg must use the first propulsion of the model.
/// Errors   why the route is closed
[[nodiscard]] tl::expected<DrivenTimes, motion::EdgeClosed> drive_in_time(const Sea& sea,
                                                                          const DrivenRoute& route,
                                                                          core::Seconds depart);

/// Removes points whose removal does not change the total cost, apart from rounding. Each merged leg gets its
/// cheapest propulsion. Stops when `stop` is requested.
[[nodiscard]] DrivenRoute drop_costless_points(const Sea& sea, const DrivenRoute& route,
                                               const Objective& objective, core::Seconds depart,
                                               const std::stop_token& stop);

/// Removes points one at a time, the cheapest first, until the next would raise the total cost above `most_cost`.
/// Fixed points stay.
[[nodiscard]] DrivenRoute drop_cheap_points(const Sea& sea, const DrivenRoute& route,
                                            const Objective& objective, core::Seconds depart,
                                            double most_cost, const std::stop_token& stop);

/// Removes points one at a time, the cheapest first, until at most `most` points are left or every further removal
/// would close the route. Fixed points stay. The cost may rise.
[[nodiscard]] DrivenRoute drop_to(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                  core::Seconds depart, std::size_t most, const std::stop_token& stop);

/// Chooses the propulsion of each leg in turn so that the total cost is least.
[[nodiscard]] DrivenRoute choose_drives(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                        core::Seconds depart, const std::stop_token& stop);

/// Divides every leg longer than `longest` into equal legs. The line of the route does not change.
[[nodiscard]] DrivenRoute part_long_legs(const PlanningDomain& domain, const DrivenRoute& route,
                                         core::Metres longest);

}  // namespace floeplan::planning::cost
