#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/flight/flight.hpp"

/// Worlds and missions for flights with known answers, around 47.5 N 52 W.
namespace floeplan::support {

inline constexpr core::UtcTime flight_start = core::from_unix_seconds(1.7e9);
inline constexpr geo::LonLat flight_origin{-52.0, 47.5};

/// Without errors of compass, speed and fixes.
inline simulation::FlightSettings perfect_sensors() {
  simulation::FlightSettings settings;
  settings.navigation = {.compass = {0.0}, .speed_share = 0.0, .fix = {0.0}, .current = {0.0}};
  return settings;
}

/// A shallow Slocum that saw-tooths from 5 to 100 m.
inline vehicle::GliderProfile shallow_glider() {
  vehicle::GliderProfile profile = *vehicle::find_profile("slocum-g3-200");
  profile.dive_depth = {100.0};
  return profile;
}

/// A list through places of the frame with the vehicle's own yo, and a surfacing at its end.
inline simulation::MissionOrders orders_through(const simulation::World& world,
                                                const std::vector<simulation::Vector>& places,
                                                double radius_m = 50.0) {
  const vehicle::GliderProfile profile = shallow_glider();
  simulation::MissionOrders orders;
  orders.name = "test";
  simulation::GotoOrders list;
  list.radius = {radius_m};
  for (const simulation::Vector& place : places) list.waypoints.push_back(world.to_lon_lat(place));
  orders.lists.push_back(list);
  orders.yo = {.dive = {.depth = profile.dive_depth,
                        .altitude = profile.altimeter_margin,
                        .pitch_rad = -profile.pitch.value,
                        .buoyancy_m3 = -profile.buoyancy.value},
               .climb = {.depth = profile.climb_to,
                         .pitch_rad = profile.pitch.value,
                         .buoyancy_m3 = profile.buoyancy.value}};
  orders.surfaces.push_back(
      {.cause = simulation::SurfaceOrders::Cause::any_idle, .ends_mission = true, .climb = orders.yo.climb});
  return orders;
}

inline simulation::FlightRecord flown(const simulation::World& world, const simulation::MissionOrders& orders,
                                      const simulation::FlightSettings& settings, std::uint64_t seed = 1) {
  simulation::BareVehicle bare;
  return simulation::fly({.world = world,
                          .orders = orders,
                          .vehicle = shallow_glider(),
                          .start = world.projection().origin(),
                          .departure = flight_start,
                          .settings = settings,
                          .seed = seed},
                         bare);
}

inline simulation::World uniform_water(double east_m_s, double north_m_s) {
  return simulation::World{
      {.origin = flight_origin,
       .bed = simulation::SeaBed{core::Metres{500.0}},
       .current = simulation::TrueCurrent{simulation::Vector{east_m_s, north_m_s, 0.0}, {}}}};
}

}  // namespace floeplan::support
