#pragma once

#include <cstdint>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/world/world.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// A sea with icebergs that are not in the plan, for tests of the onboard avoidance.
struct IcebergFieldSettings {
  core::Metres route{5000.0};  // length of the route, eastwards
  double km2_for_each{1.5};
  core::Metres median_length{70.0};
  double length_sigma{0.6};  // standard deviation of its logarithm: seven in ten bergs are 38 to 128 m long
  core::Metres least_length{20.0};
  core::Metres greatest_length{200.0};
  double most_drift{0.5};                    // through the water, as a share of the vehicle's speed
  double most_spin_deg_h{30.0};              // an assumption: no statistics were found
  core::MetresPerSecond current{0.05};       // of the forecast, in a random direction
  core::MetresPerSecond current_error{0.1};  // rms of the vector: 0.07 m/s per component
  core::Metres free_about_start{200.0};      // no glider is started next to a berg
  core::Metres dive_depth{
      30.0};  // less than the draft of most bergs: deeper dives would pass under some by luck
};

/// A world, a mission through it with hourly surfacings, and the vehicle. The start is the world's origin.
struct IcebergField {
  World world;
  MissionOrders orders;
  vehicle::GliderProfile vehicle;
  geo::VelocityEn forecast;  // forecast current, without its error
};

/// The iceberg field of a seed. Bergs lie at random in all directions from which they can drift onto the
/// route.
/// Bergs   random shapes; log-normal lengths within the limits; they drift with the true current at half
///         their draft and at a constant velocity through the water in any direction
/// Errors  std::invalid_argument unless lengths, area and route are positive and the least length is below
///         the greatest
[[nodiscard]] IcebergField random_icebergs(const IcebergFieldSettings& settings, geo::LonLat start,
                                           core::UtcTime departure, std::uint64_t seed);

/// Time limit of a flight: four times the duration in still water, because the current may be against it.
[[nodiscard]] core::Seconds longest_flight(const IcebergFieldSettings& settings,
                                           const vehicle::GliderProfile& vehicle);

}  // namespace floeplan::simulation
