#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"

namespace floeplan::planning::cost {

/// Where and when a route stops being passable.
struct RouteClosed {
  motion::EdgeClosed reason{};
  geo::PlanePoint at;
  core::Seconds when{};
  bool out_of_time{false};  // the data reach on from here, but not long enough
};

/// When the vehicle comes to each point of a route, and how long it stays there before it goes on.
struct Schedule {
  std::vector<core::Seconds> arrivals;  // the departure first
  std::vector<core::Seconds> waits;     // zero but where something in the way opens later

  [[nodiscard]] core::Seconds leaves(std::size_t i) const { return arrivals[i] + waits[i]; }
};

}  // namespace floeplan::planning::cost
