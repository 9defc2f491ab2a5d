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

/// The sensors of a vehicle, constructed once for any number of flights.
struct Equipment {
  Sonar sonar{SonarSettings{}};
  Altimeter altimeter{AltimeterSettings{}};
  AdcpErrorModel adcp{AdcpSettings{}};
};

/// Input for constructing the onboard avoidance for one flight.
struct SystemOnBoard {
  std::vector<geo::PlanePoint> waypoints;  // of the mission, in the plane of the world
  avoidance::CarriedForecast forecast;
  avoidance::AvoidanceSettings settings{};
};

/// The waypoints that a mission flies (`flight_path`) and the forecast around its route, as loaded into the
/// vehicle. Forecast at most 24 x 24 places, 4 depths of the saw-tooth and 48 times: as much as such a
/// computer stores
[[nodiscard]] SystemOnBoard system_for(const World& world, const MissionOrders& orders, geo::LonLat start,
                                       core::UtcTime departure, core::Seconds duration);

/// Settings of the onboard avoidance that fit a vehicle, its mission and its sonar.
[[nodiscard]] avoidance::AvoidanceSettings avoidance_for(const vehicle::GliderProfile& vehicle,
                                                         const MissionOrders& orders,
                                                         const SonarSettings& sonar);

/// Settings for the vehicle with full knowledge, to judge a flight with this sonar.
[[nodiscard]] ForesightSettings foresight_of(const vehicle::GliderProfile& vehicle,
                                             const MissionOrders& orders, const SonarSettings& sonar);

/// A vehicle with altimeter and, if `system` is given, with sonar, ADCP and onboard avoidance.
/// Log      at most one reading a minute of each sensor, and a profile of currents every ten minutes: as much
///          as a pilot reads
/// Chance   each sensor has its own random stream from the flight's seed
/// Threads  one flight at a time
class EquippedVehicle {
 public:
  /// `world` is borrowed.
  EquippedVehicle(const Equipment& equipment, const World& world, std::uint64_t seed,
                  const std::optional<SystemOnBoard>& system, std::stop_token stop = {});

  [[nodiscard]] OnBoardAnswer step(const FlightView& view);

  /// Readings of the sensors so far. Fixes are recorded by the flight.
  [[nodiscard]] const SensorLog& log() const { return log_; }

 private:
  /// Whether a sensor with this interval is due. After true, it is false until the next interval.
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
