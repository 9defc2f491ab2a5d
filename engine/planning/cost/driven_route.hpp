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

/// A route and what drives the vehicle along each of its legs.
struct DrivenRoute {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;             // start, goal and vias
  std::vector<vehicle::Drive> drives;  // one for each leg
};

/// When the vehicle is where, and what it draws in all.
struct DrivenTimes {
  std::vector<core::Seconds> arrivals;  // one for each point, the departure first
  EnergyUse energy;
  double encounters{};              // with icebergs, where they have a weight
  core::Seconds since_surfacing{};  // at the end of a drive without waits

  [[nodiscard]] double cost(const Objective& objective) const {
    return objective.cost(arrivals.back() - arrivals.front(), energy.total(), encounters);
  }
};

/// Without waits; the time without a possible surfacing keeps the request's bound.
/// Errors   why the route is closed
[[nodiscard]] tl::expected<DrivenTimes, motion::EdgeClosed> drive_along(
    const Sea& sea, const DrivenRoute& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0}, Dives dives = Dives::over_bed);

/// The same; where every leg is on the sea's first drive the vehicle waits where the request allows it and that brings
/// it through.
[[nodiscard]] tl::expected<DrivenTimes, motion::EdgeClosed> drive_in_time(const Sea& sea,
                                                                          const DrivenRoute& route,
                                                                          core::Seconds depart);

/// Takes out points, each merged leg on the drive that suits it best, as long as the whole costs no more than at first
/// and a step no more than by rounding, or until `stop` is requested.
[[nodiscard]] DrivenRoute drop_costless_points(const Sea& sea, const DrivenRoute& route,
                                               const Objective& objective, core::Seconds depart,
                                               const std::stop_token& stop);

/// Takes out the points that cost least, one at a time, until the next would make the whole cost more than `most_cost`;
/// fixed points stay.
[[nodiscard]] DrivenRoute drop_cheap_points(const Sea& sea, const DrivenRoute& route,
                                            const Objective& objective, core::Seconds depart,
                                            double most_cost, const std::stop_token& stop);

/// Takes out the points that cost least, one at a time, until at most `most` are left or none can go without the
/// route closing; fixed points stay. The route may cost more.
[[nodiscard]] DrivenRoute drop_to(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                  core::Seconds depart, std::size_t most, const std::stop_token& stop);

/// Puts each leg in turn on the drive that makes the whole cost least.
[[nodiscard]] DrivenRoute choose_drives(const Sea& sea, const DrivenRoute& route, const Objective& objective,
                                        core::Seconds depart, const std::stop_token& stop);

/// Parts every leg that is longer than `longest` into equal ones; the way is the same.
[[nodiscard]] DrivenRoute part_long_legs(const Sea& sea, const DrivenRoute& route, core::Metres longest);

}  // namespace floeplan::planning::cost
