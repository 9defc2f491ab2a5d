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
  core::Seconds first_fix{60.0};          // from coming up to the first fix
  core::Seconds longest{30.0 * 86400.0};  // the flight ends then at the latest
  core::Seconds record_every{10.0};       // of the track
  core::Metres reach{500.0};        // within which bodies are at hand for sensors and closest approaches
  core::Metres hull_reach{0.75};    // a body nearer than half the hull's 1.5 m is touched
  geo::VelocityEn known_current{};  // what the vehicle reckons with on its first dive
  bool ends_at_contact{true};       // false: the contact is recorded, and the vehicle goes on through

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

/// All that a flight depends on. The world and the orders are borrowed and must outlive it.
struct FlightRequest {
  const World& world;
  const MissionOrders& orders;
  vehicle::GliderProfile vehicle{};
  geo::LonLat start{};  // at the surface, with a fix
  core::UtcTime departure{};
  FlightSettings settings{};
  std::uint64_t seed{};
};

/// Why this mission cannot be flown in this world: settings and vehicle out of range, a start or a waypoint outside the
/// data, a start on land or under ice, data that end long before it could arrive. Empty when it can.
[[nodiscard]] core::Violations violations(const FlightRequest& request);

/// What there is to sense at a step: for the sensors' models. The vehicle's own computer sees `own` alone.
struct FlightView {
  const World& world;
  const TrueState& truth;
  NearbyBodies& bodies;            // within FlightSettings::reach
  const avoidance::OwnState& own;  // without altitude: that is an answer
  std::size_t waypoint{};          // under way, of all the mission's rows as flown
};

/// What sensors and the system on board answer to a step.
struct OnBoardAnswer {
  avoidance::Guidance guidance{};
  std::optional<core::Metres> altitude{};  // above the sea bed by the altimeter, where it has an echo
};

/// Sensors and the system on board, asked once a second, at the surface too.
template <class T>
concept OnBoard = requires(T& on_board, const FlightView& view) {
  { on_board.step(view) } -> std::convertible_to<OnBoardAnswer>;
};

/// A vehicle as it is delivered: an altimeter that hears the bed straight below within its range, and no system on
/// board.
struct BareVehicle {
  core::Metres altimeter_range{100.0};  // of the usual altimeter; farther there is no echo

  [[nodiscard]] OnBoardAnswer step(const FlightView& view) const;
};

/// One flight, second by second. `fly` below is the usual way to it.
class Flight {
 public:
  /// Errors   std::invalid_argument for a request with violations
  explicit Flight(const FlightRequest& request);
  ~Flight();
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;

  [[nodiscard]] bool is_under_way() const;
  [[nodiscard]] FlightView view();
  /// One second on, with what sensors and system answered.
  void step(const OnBoardAnswer& answer);
  /// Ends the flight before it ends by itself.
  void stop();
  /// Once, at the end.
  [[nodiscard]] FlightRecord take_record();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Flies a mission in a world: the loop of world, vehicle, sensors and system on board.
/// Laws     the same request gives the same record, bit by bit, whatever else runs
/// Errors   std::invalid_argument for a request with violations
/// Stops    within a second of simulated time of `stop`, with a record that says so
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
