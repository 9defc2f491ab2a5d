#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <stop_token>
#include <vector>

#include "engine/avoidance/avoidance_system.hpp"
#include "engine/simulation/flight/flight.hpp"
#include "engine/simulation/flight/hindsight.hpp"
#include "engine/simulation/sensors/adcp_error_model.hpp"
#include "engine/simulation/sensors/altimeter.hpp"
#include "engine/simulation/sensors/sonar.hpp"
#include "engine/simulation/sensors/sound_rays.hpp"

namespace floeplan::simulation {

/// The sensors of a vehicle, laid out once for any number of flights.
struct Equipment {
  Sonar sonar{SonarSettings{}};
  Altimeter altimeter{AltimeterSettings{}};
  AdcpErrorModel adcp{AdcpSettings{}};
};

/// What the obstacle avoidance system is built from for one flight.
struct SystemOnBoard {
  std::vector<geo::PlanePoint> waypoints;  // of the mission, in the plane of the world
  avoidance::CarriedForecast forecast;
  avoidance::AvoidanceSettings settings{};
};

/// The waypoints that a mission flies (`flight_path`) and the forecast about its route, as they are loaded into the vehicle.
/// Forecast at most 24 places to a side, 4 depths of the saw-tooth and 48 times: what such a computer carries
[[nodiscard]] SystemOnBoard system_for(const World& world, const MissionOrders& orders, geo::LonLat start,
                                       core::UtcTime departure, core::Seconds duration);

/// The settings of the system that fit a vehicle, its mission and its sonar.
[[nodiscard]] avoidance::AvoidanceSettings avoidance_for(const vehicle::GliderProfile& vehicle,
                                                         const MissionOrders& orders,
                                                         const SonarSettings& sonar);

/// What a vehicle of full knowledge could do, for the judgement of a flight with that sonar.
[[nodiscard]] ForesightSettings foresight_of(const vehicle::GliderProfile& vehicle,
                                             const MissionOrders& orders, const SonarSettings& sonar);

/// A vehicle with altimeter and, where a system on board is given, sonar, ADCP and that system.
/// Log      at most one reading a minute of each sensor, and a profile of currents every ten minutes: as much as a pilot
///          reads
/// Chance   each sensor has its own stream of the flight's seed
/// Threads  one flight at a time
class EquippedVehicle {
 public:
  /// `world` is borrowed.
  EquippedVehicle(const Equipment& equipment, const World& world, std::uint64_t seed,
                  const std::optional<SystemOnBoard>& system, std::stop_token stop = {});

  [[nodiscard]] OnBoardAnswer step(const FlightView& view);

  /// What the sensors told so far; the fixes are the flight's.
  [[nodiscard]] const SensorLog& log() const { return log_; }

 private:
  /// Whether a sensor that works at such intervals is due; it then is not until the next.
  class Clock {
   public:
    explicit Clock(core::Seconds interval) : interval_{interval} {}
    [[nodiscard]] bool is_due(core::UtcTime time);

   private:
    core::Seconds interval_;
    std::optional<core::UtcTime> next_{};
  };

  void sound(const FlightView& view);
  void profile_current(const FlightView& view, avoidance::Sensed& sensed);
  void hear(const FlightView& view, avoidance::Sensed& sensed);

  Sonar sonar_;
  Altimeter altimeter_;
  AdcpErrorModel adcp_;
  SoundRays rays_;
  std::optional<avoidance::AvoidanceSystem> system_;
  std::stop_token stop_;
  std::mt19937_64 sonar_rng_;
  std::mt19937_64 altimeter_rng_;
  std::mt19937_64 adcp_rng_;
  Clock ping_due_;
  Clock altitude_due_;
  Clock profile_due_;
  Clock log_ping_;
  Clock log_altitude_;
  Clock log_profile_;
  std::optional<core::Metres> altitude_{};
  ReferenceError reference_{};
  std::optional<core::UtcTime> last_profile_{};
  SensorLog log_;
};

}  // namespace floeplan::simulation
