#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "tests/engine/simulation/flown.hpp"

namespace floeplan::support {

/// A flight of the shallow glider with all its sensors, and the system on board.
struct GuidedFlight {
  std::vector<simulation::Vector> way{{800.0, 0.0, 0.0}};
  core::Seconds longest{4.0 * 3600.0};
  std::uint64_t seed{1};
  bool has_system{true};
  simulation::SonarSettings sonar{};
  core::Seconds same_depth{1800.0};  // of abend
};

inline simulation::FlightRecord guided(const simulation::World& world, const GuidedFlight& flight) {
  const simulation::Equipment equipment{.sonar = simulation::Sonar{flight.sonar}};
  const vehicle::GliderProfile vehicle = simulation::flown_vehicle(shallow_glider()).value();
  simulation::MissionOrders orders = orders_through(world, flight.way);
  orders.same_depth = flight.same_depth;
  std::optional<simulation::SystemOnBoard> system;
  if (flight.has_system) {
    system = simulation::system_for(world, orders, flight_origin, flight_start, flight.longest);
    system->settings = simulation::avoidance_for(vehicle, orders, flight.sonar);
  }
  simulation::FlightSettings settings;
  settings.longest = flight.longest;
  simulation::EquippedVehicle on_board{equipment, world, flight.seed, system};
  return simulation::fly({.world = world,
                          .orders = orders,
                          .vehicle = vehicle,
                          .start = flight_origin,
                          .departure = flight_start,
                          .settings = settings,
                          .seed = flight.seed},
                         on_board);
}

/// Share of the points of the track at which the system on board steered.
inline double share_steered(const simulation::FlightRecord& record) {
  const auto steered = std::ranges::count_if(record.track, [](const simulation::TrackPoint& point) {
    return point.mode != avoidance::Mode::mission;
  });
  return static_cast<double>(steered) / static_cast<double>(record.track.size());
}

inline double nearest_m(const simulation::FlightRecord& record, const std::string& to) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const simulation::ClosestApproach& approach : record.approaches) {
    if (approach.to.starts_with(to)) nearest = std::min(nearest, approach.distance_m);
  }
  return nearest;
}

}  // namespace floeplan::support
