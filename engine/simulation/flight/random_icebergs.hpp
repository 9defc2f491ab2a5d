#pragma once

#include <cstdint>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/world/world.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// A sea full of icebergs that the plan does not know: what the obstacle avoidance system is proved in.
struct IcebergFieldSettings {
  core::Metres route{5000.0};  // eastward
  double km2_for_each{1.5};
  core::Metres median_length{70.0};
  double length_sigma{0.6};  // of its logarithm: seven in ten bergs are between 38 and 128 m long
  core::Metres least_length{20.0};
  core::Metres greatest_length{200.0};
  double most_drift{0.5};                    // through the water, of the vehicle's speed
  double most_spin_deg_h{30.0};              // an assumption, for no statistics were at hand
  core::MetresPerSecond current{0.05};       // of the forecast, in any direction
  core::MetresPerSecond current_error{0.1};  // rms of the vector: 0.07 m/s of either component
  core::Metres free_about_start{200.0};      // nobody starts a glider beside a berg
  core::Metres dive_depth{
      30.0};  // less than the draft of most bergs: deeper dives pass under some of them by luck
};

/// A world, a mission through it that comes up every hour for a fix, and who flies it. The start is the world's origin.
struct IcebergField {
  World world;
  MissionOrders orders;
  vehicle::GliderProfile vehicle;
  geo::VelocityEn forecast;  // of the current, without its error
};

/// The field of a seed. Bergs lie at random in all directions from which they can drift onto the route.
/// Bergs   of random forms; lengths log-normal within the limits; they drift with the true current at half their draft
///         and steadily through it, in any direction
/// Errors  std::invalid_argument unless lengths, area and route are positive and the least length is below the greatest
[[nodiscard]] IcebergField random_icebergs(const IcebergFieldSettings& settings, geo::LonLat start,
                                           core::UtcTime departure, std::uint64_t seed);

/// For how long a vehicle may take for its way: four times what it takes straight: the current may be against it.
[[nodiscard]] core::Seconds longest_flight(const IcebergFieldSettings& settings,
                                           const vehicle::GliderProfile& vehicle);

}  // namespace floeplan::simulation
