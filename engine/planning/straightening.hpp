#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// A route and which of its points must stay.
struct Route {
  std::vector<geo::PlanePoint> points;
  std::vector<bool> fixed;  // start, goal and vias
};

/// Joins legs that run on in the same direction; the way is the same.
[[nodiscard]] Route join_collinear(const Route& route);

/// Takes out points as long as the arrival does not become later, or until `stop` is requested.
[[nodiscard]] Route drop_needless_points(const Sea& sea, const Route& route, core::Seconds depart,
                                         const std::stop_token& stop = {});

/// Takes out the points that cost least, one at a time, until at most `most` are left or none can go without
/// the route closing; fixed points stay. The arrival may become later.
[[nodiscard]] Route drop_to(const Sea& sea, const Route& route, core::Seconds depart, std::size_t most);

/// Parts every leg that is longer than `longest` into equal ones; the way is the same.
[[nodiscard]] Route part_long_legs(const Sea& sea, const Route& route, core::Metres longest);

}  // namespace floeplan::planning
