#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// How the pilot on shore ends a hold.
struct HoldEnd {
  core::UtcTime planned{};
  std::size_t next{};  // index of the stop that follows after the hold
};

/// One place of the route along the goto lists, in the frame of the flight.
struct RouteStop {
  Vector place{};
  double radius_m{};
  bool ends_list{};  // end of a list that another one follows
  std::optional<HoldEnd> hold{};
};

/// The route that the vehicle's computer flies: all flown rows of its goto lists, one list after another.
struct FlightPath {
  std::vector<RouteStop> stops;
  std::optional<std::size_t> loops_to;  // first stop of a list without end, which repeats after the last stop
};

/// Makes the route from the start along all lists. A list without end must be the last one.
/// Holds    a list with a planned end, which another one follows, is repeated as often as it may be flown
///          until then: its stops have a HoldEnd
/// Rule     mission::flown_rows; the closest row is closest in the frame of the world
[[nodiscard]] FlightPath flight_path(const World& world, const MissionOrders& orders, geo::LonLat start);

}  // namespace floeplan::simulation
