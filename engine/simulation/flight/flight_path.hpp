#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// How the pilot ashore ends a hold.
struct HoldEnd {
  core::UtcTime planned{};
  std::size_t next{};  // the stop that follows then
};

/// One place of the route that the goto lists make, in the frame of the flight.
struct RouteStop {
  Vector place{};
  double radius_m{};
  bool ends_list{};  // and another list follows
  std::optional<HoldEnd> hold{};
};

/// What the vehicle's own computer flies by: the rows of its goto lists that are flown, laid end to end.
struct FlightPath {
  std::vector<RouteStop> stops;
  std::optional<std::size_t> loops_to;  // after the last stop, for a list that goes round and round
};

/// Lays the lists end to end from where the vehicle starts; a list that goes round and round is the last.
/// Holds    a list that says when it is to end, and that another one follows, is laid as often as it may be flown until
///          then: its stops have a HoldEnd
/// Rule     mission::flown_rows; the closest row is that in the frame of the world
[[nodiscard]] FlightPath flight_path(const World& world, const MissionOrders& orders, geo::LonLat start);

}  // namespace floeplan::simulation
