#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "engine/avoidance/guidance.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/simulation/flight/flight_record.hpp"
#include "engine/simulation/vehicle/dead_reckoning.hpp"
#include "engine/simulation/vehicle/glider_motion.hpp"
#include "engine/simulation/vehicle/mission_orders.hpp"
#include "engine/simulation/vehicle/true_state.hpp"
#include "engine/simulation/world/world.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

struct FlightSettings {
  HullMotion hull{};
  NavigationErrors navigation{};
  core::Seconds first_fix{60.0};          // time from surfacing to the first fix
  core::Seconds longest{30.0 * 86400.0};  // the flight ends at this time at the latest
  core::Seconds record_every{10.0};       // interval of the track's points
  core::Metres reach{500.0};              // bodies within it are used for sensors and closest approaches
  core::Metres hull_reach{0.75};          // a body nearer than half the hull's length of 1.5 m is touched
  geo::VelocityEn known_current{};        // current that the vehicle assumes on its first dive
  bool ends_at_contact{true};             // false: a contact is recorded and the flight continues

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// The input of a flight. World and orders are borrowed and must outlive it.
struct FlightRequest {
  const World& world;
  const MissionOrders& orders;
  vehicle::GliderProfile vehicle{};
  geo::LonLat start{};  // at the surface, with a fix
  core::UtcTime departure{};
  FlightSettings settings{};
  std::uint64_t seed{};
};

/// Why this mission cannot be flown in this world: settings or vehicle out of range, a start or waypoint
/// outside the data, a start on land or under ice, data that end long before the vehicle can arrive. Empty:
/// it can be flown.
[[nodiscard]] core::Violations violations(const FlightRequest& request);

/// The state that the models of the sensors may use at a step. The vehicle's own computer uses only `own`.
struct FlightView {
  const World& world;
  const TrueState& truth;
  NearbyBodies& bodies;            // within FlightSettings::reach
  const avoidance::OwnState& own;  // without altitude, which the sensors return
  std::size_t waypoint{};          // index of the next waypoint, among all rows as flown
};

/// Output of sensors and onboard avoidance at a step.
struct OnBoardAnswer {
  avoidance::Guidance guidance{};
  std::optional<core::Metres> altitude{};  // above the sea bed, by the altimeter; empty: no echo
};

/// Sensors and onboard avoidance. `step` is called once a second, at the surface, too.
template <class T>
concept OnBoard = requires(T& on_board, const FlightView& view) {
  { on_board.step(view) } -> std::convertible_to<OnBoardAnswer>;
};

/// A vehicle as delivered: an altimeter that measures the bed straight below within its range, and no onboard
/// avoidance.
struct BareVehicle {
  core::Metres altimeter_range{100.0};  // of the usual altimeter; no echo beyond

  [[nodiscard]] OnBoardAnswer step(const FlightView& view) const;
};

/// One flight, second by second. Usually called through `fly` below.
class Flight {
 public:
  /// Errors   std::invalid_argument for a request with violations
  explicit Flight(const FlightRequest& request);
  ~Flight();
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  [[nodiscard]] bool is_under_way() const;
  [[nodiscard]] FlightView view();
  /// Advances by one second with this output of sensors and avoidance.
  void step(const OnBoardAnswer& answer);
  /// Ends the flight early.
  void stop();
  /// The record of the flight. Call once, at the end.
  [[nodiscard]] FlightRecord take_record();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Flies a mission in a world: the loop over world, vehicle, sensors and onboard avoidance.
/// Laws     the same request gives the same record, bit by bit, whatever else runs
/// Errors   std::invalid_argument for a request with violations
/// Stops    within a second of simulated time after `stop` is requested, with a record that says so
template <OnBoard T>
[[nodiscard]] FlightRecord fly(const FlightRequest& request, T& on_board, const std::stop_token& stop = {}) {
  Flight flight{request};
  while (flight.is_under_way()) {
    if (stop.stop_requested()) {
      flight.stop();
      break;
    }
    const FlightView view = flight.view();
    flight.step(on_board.step(view));
  }
  return flight.take_record();
}

}  // namespace floeplan::simulation
