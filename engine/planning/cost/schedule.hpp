#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"

namespace floeplan::planning::cost {

/// Where and when a route is closed.
struct RouteClosed {
  motion::EdgeClosed reason{};
  geo::PlanePoint at;
  core::Seconds when{};
  bool out_of_time{false};  // the data cover `when`, but end before the route does
};

/// When the vehicle reaches each point of a route, and how long it holds there.
struct Schedule {
  std::vector<core::Seconds> arrivals;  // the departure is the first
  std::vector<core::Seconds> waits;     // zero, except for a hold until a closure ends

  [[nodiscard]] core::Seconds leaves(std::size_t i) const { return arrivals[i] + waits[i]; }
};

}  // namespace floeplan::planning::cost
