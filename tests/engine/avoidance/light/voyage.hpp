#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/avoidance/avoidance_system.hpp"
#include "tests/engine/avoidance/light/body.hpp"

namespace floeplan::support {

/// The light test bed: an ideal vehicle with a sonar of straight rays. Everything that is random comes from the seed.
struct LightSonar {
  double range_m{200.0};
  double half_width_deg{60.0};
  double bearing_step_deg{3.0};
  std::vector<double> elevations_deg{-30.0, -15.0, 0.0, 15.0, 30.0};
  double range_sigma_m{1.0};
  double bearing_sigma_deg{1.0};
  double detection{
      0.9};  // of a beam that meets a body, up to three quarters of the range; half of it at the end
  double false_alarms{0.3};  // of a ping, in the mean
  double every_s{1.0};
};

struct LightVehicle {
  double through_water_m_s{0.35};
  double pitch_deg{26.0};
  double turn_deg_s{2.0};
  double shallowest_m{5.0};
  double deepest_m{30.0};
  double compass_sigma_deg{2.0};  // one bias for each flight
  double speed_sigma{0.03};       // of the assumed speed through the water, one for each flight
  double fix_every_s{3600.0};
};

struct LightSea {
  std::vector<Body> bodies;
  std::optional<double> bed_m;
  geo::VelocityEn forecast;
  double current_error_m_s{};  // rms of a component, over time; 0: the forecast is exact
  double current_error_scale_s{6.0 * 3600.0};
};

struct Flight {
  LightSea sea;
  LightVehicle vehicle;
  LightSonar sonar;
  std::vector<geo::PlanePoint> waypoints;
  avoidance::AvoidanceSettings settings;
  double most_s{};
  std::uint64_t seed{1};
  bool avoids{true};
  bool plans_paths{true};  // false: reactive control alone
};

enum class Ending { arrived, collided, too_long, gave_up };

/// The place of the vehicle when its sonar first met a body.
struct Sighting {
  double time_s{};
  SeaPoint place{};
  geo::PlanePoint carried{};  // how far the water had come since the start
  double heading_rad{};
};

struct FlightResult {
  Ending ending{};
  double time_s{};
  double way_m{};  // through the water
  SeaPoint last{};
  std::size_t collided_with{};
  std::optional<Sighting> first_seen{};  // of that body
  avoidance::Reason reason{};            // of the last guidance
  avoidance::AvoidanceCounters counters{};
  double reactive_s{};
  double deepest_m{};        // reached
  double shallowest_m{1e9};  // once below the first ten metres
};

/// Called after each step with the seconds, the true position, the answer of the system, and the system.
using Watcher = std::function<void(double, const SeaPoint&, const avoidance::Guidance&,
                                   const avoidance::AvoidanceSystem&)>;

[[nodiscard]] FlightResult fly(const Flight& flight, const Watcher& watch = {});

/// A vehicle nearer than this to the surface of a body has collided with it.
inline constexpr double hull_m = 1.0;

}  // namespace floeplan::support
