#include "engine/simulation/flight/flight.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/messages/flight_messages.hpp"
#include "engine/simulation/flight/contact_watch.hpp"
#include "engine/simulation/flight/mission_pilot.hpp"
#include "engine/simulation/vehicle/energy_meter.hpp"

namespace floeplan::simulation {
namespace {

constexpr core::Seconds step_length{1.0};
constexpr double step_s = step_length.count();
/// A hull this near to the surface floats: pressure sensors are accurate to centimetres.
constexpr double at_surface_m = 0.1;

}  // namespace

OnBoardAnswer BareVehicle::step(const FlightView& view) const {
  const Vector& place = view.truth.position;
  const auto bed_m = view.world.bed_depth_m(place.east, place.north);
  OnBoardAnswer answer;
  if (bed_m && *bed_m - place.down <= altimeter_range.value)
    answer.altitude = core::Metres{std::max(0.0, *bed_m - place.down)};
  return answer;
}

class Flight::State {
 public:
  explicit State(const FlightRequest& request)
      : request_{request},
        settings_{request.settings},
        world_{request.world},
        near_{world_, settings_.reach},
        motion_{request.vehicle, settings_.hull, 0.0},
        reckoning_{settings_.navigation, world_.to_frame(request.start), known_current(request),
                   request.orders.corrects_for_current, request.seed},
        pilot_{request.orders, flight_path(world_, request.orders, request.start), settings_.first_fix,
               request.departure},
        energy_{request.vehicle},
        watch_{world_, settings_.reach, settings_.hull_reach} {
    truth_.time = request.departure;
    truth_.position = world_.to_frame(request.start);
    record_.seed = request.seed;
    record_.departure = request.departure;
    event(EventKind::departure, "");
    observe();
    keep_point(avoidance::Mode::mission);
  }

  [[nodiscard]] bool is_under_way() const { return !ended_; }

  FlightView view() { return {world_, truth_, near_, own_, pilot_.waypoint()}; }

  void step(const OnBoardAnswer& answer) {
    command(answer);
    if (ended_) return;
    move();
    if (ended_) return;
    observe();
    if (truth_.time - last_kept_ >= settings_.record_every) keep_point(answer.guidance.mode);
    if (energy_.is_empty()) end(FlightEnd::battery, messages::flight_text<"flight-battery-empty">());
    if (truth_.time - record_.departure >= settings_.longest)
      end(FlightEnd::time_up, messages::flight_text<"flight-too-long">());
  }

  void end(FlightEnd kind, std::string reason) {
    if (ended_) return;
    ended_ = true;
    record_.end = kind;
    record_.end_reason = std::move(reason);
    record_.finished = truth_.time;
    record_.energy = energy_.drawn();
    record_.teeth = inflections_ / 2;
    event(EventKind::end, record_.end_reason);
    if (last_kept_ != truth_.time) keep_point(mode_);
    record_.approaches = watch_.approaches();
  }

  FlightRecord take_record() { return std::move(record_); }

 private:
  static Vector known_current(const FlightRequest& request) {
    const geo::PlaneVelocity in_plane =
        request.world.projection().to_plane(request.settings.known_current, request.start);
    return {in_plane.x_m_s, in_plane.y_m_s, 0.0};
  }

  [[nodiscard]] bool floats() const {
    return truth_.position.down <= at_surface_m && motion_.sinking_m_s() <= 0.0;
  }

  /// The vehicle's computer: first the behaviors, then the control loops of heading, pitch and pump.
  void command(const OnBoardAnswer& answer) {
    const MissionPilot::Known known{
        .time = truth_.time,
        .place = {reckoning_.place().east, reckoning_.place().north, truth_.position.down},
        .floats = floats(),
        .altitude = answer.altitude,
        .current = reckoning_.assumed_current(),
        .speed_m_s = reckoning_.mean_speed_m_s().value_or(request_.vehicle.speed_through_water.value)};
    const MissionPilot::Turned turned = pilot_.step(known, answer.guidance);
    if (turned.waypoint) event(EventKind::waypoint, "waypoint " + std::to_string(*turned.waypoint + 1));
    if (turned.inflected) {
      energy_.inflect();
      ++inflections_;
      event(EventKind::inflection, "");
    }
    if (turned.surfaced) {
      reckoning_.surface(truth_.time);
      energy_.surface();
      event(EventKind::surfacing, "");
    }
    if (turned.fixed) fix();
    if (turned.dived) {
      reckoning_.dive(truth_.time);
      event(EventKind::dive, "");
    }
    if (answer.guidance.mode != mode_) {
      mode_ = answer.guidance.mode;
      event(EventKind::guidance, std::string{avoidance::text(mode_)} + ": " +
                                     std::string{avoidance::text(answer.guidance.reason)});
    }
    if (pilot_.phase() == MissionPilot::Phase::done)
      return end(pilot_.has_arrived() ? FlightEnd::arrived : FlightEnd::gave_up, pilot_.reason());
    targets_ = pilot_.targets(known, answer.guidance);
    // The loop turns the vehicle until the compass shows the heading, so the true heading is off by the
    // compass error.
    targets_.heading_rad += targets_.heading_rad - reckoning_.measured_heading_rad(targets_.heading_rad);
    const bool thruster = pilot_.uses_thruster(answer.guidance) && request_.vehicle.thruster;
    targets_.thruster_speed_m_s = thruster ? request_.vehicle.thruster->speed.value : 0.0;
  }

  void fix() {
    FixEntry entry{.time = truth_.time, .fixed = {}, .believed = reckoning_.place(), .depth_averaged = {}};
    reckoning_.fix(truth_.position, truth_.time);
    entry.fixed = reckoning_.place();
    const Vector current = reckoning_.depth_averaged_current();
    entry.depth_averaged = {{current.east}, {current.north}};
    record_.sensors.fixes.push_back(entry);
    event(EventKind::fix, "");
  }

  /// Moves pump, hull and water for one second.
  void move() {
    const double pumped_m3 = motion_.buoyancy_m3();
    motion_.advance(targets_, truth_.position.down);
    energy_.pump(motion_.buoyancy_m3() - pumped_m3, truth_.position.down);
    energy_.run(step_length, targets_.thruster_speed_m_s > 0.0);

    const Vector through_water = motion_.through_water();
    const Vector halfway = truth_.position + 0.5 * step_s * through_water;
    const auto water = world_.current(halfway, truth_.time + 0.5 * step_length);
    if (!water) return end(FlightEnd::left_data, messages::flight_text<"flight-left-currents">());

    const Vector before = truth_.position;
    truth_.position = truth_.position + step_s * (through_water + *water);
    truth_.position.down = std::max(0.0, truth_.position.down);
    truth_.time += step_length;
    truth_.attitude = motion_.attitude();
    truth_.through_water = through_water;
    truth_.over_ground = (1.0 / step_s) * (truth_.position - before);
    record_.distance_m +=
        std::hypot(truth_.position.east - before.east, truth_.position.north - before.north);
    const bool under_water = pilot_.phase() != MissionPilot::Phase::at_surface;
    if (under_water)
      reckoning_.advance(motion_.attitude().heading_rad, motion_.horizontal_m_s(), step_length);

    const auto contact = watch_.look(truth_.position, truth_.time, near_);
    if (!contact) {
      in_contact_ = false;
      return;
    }
    if (!in_contact_) event(EventKind::contact, contact->with);
    in_contact_ = true;
    if (settings_.ends_at_contact) end(contact->kind, "The vehicle touched: " + contact->with + ".");
  }

  void observe() {
    own_.time = truth_.time;
    own_.place = {reckoning_.place().east, reckoning_.place().north};
    own_.place_sigma = {reckoning_.sigma_m(truth_.time)};
    own_.depth = {truth_.position.down};
    own_.attitude = {{wrapped_angle(reckoning_.measured_heading_rad(truth_.attitude.heading_rad))},
                     {truth_.attitude.pitch_rad},
                     {truth_.attitude.roll_rad}};
    own_.through_water = {reckoning_.mean_speed_m_s().value_or(request_.vehicle.speed_through_water.value)};
    own_.altitude.reset();
    own_.at_surface = pilot_.phase() == MissionPilot::Phase::at_surface;
    own_.waypoint = pilot_.waypoint();
  }

  void keep_point(avoidance::Mode mode) {
    last_kept_ = truth_.time;
    record_.track.push_back({.time = truth_.time,
                             .position = truth_.position,
                             .believed = {own_.place.x_m, own_.place.y_m, own_.depth.value},
                             .sigma_m = own_.place_sigma.value,
                             .attitude = truth_.attitude,
                             .over_ground = truth_.over_ground,
                             .energy = energy_.drawn(),
                             .at_surface = own_.at_surface,
                             .mode = mode});
  }

  void event(EventKind kind, std::string text) {
    record_.events.push_back(
        {.time = truth_.time, .kind = kind, .position = truth_.position, .text = std::move(text)});
  }

  FlightRequest request_;
  FlightSettings settings_;
  const World& world_;
  NearbyBodies near_;
  GliderMotion motion_;
  DeadReckoning reckoning_;
  MissionPilot pilot_;
  EnergyMeter energy_;
  ContactWatch watch_;
  TrueState truth_;
  avoidance::OwnState own_;
  ActuatorTargets targets_;
  avoidance::Mode mode_{avoidance::Mode::mission};
  FlightRecord record_;
  core::UtcTime last_kept_{};
  int inflections_{};
  bool in_contact_{};
  bool ended_{};
};

Flight::Flight(const FlightRequest& request) {
  const core::Violations found = violations(request);
  if (!found.empty()) throw std::invalid_argument{found.front().field + " " + found.front().rule};
  state_ = std::make_unique<State>(request);
}

Flight::~Flight() = default;

bool Flight::is_under_way() const { return state_->is_under_way(); }
FlightView Flight::view() { return state_->view(); }
void Flight::step(const OnBoardAnswer& answer) { state_->step(answer); }
void Flight::stop() { state_->end(FlightEnd::stopped, messages::flight_text<"flight-stopped">()); }
FlightRecord Flight::take_record() { return state_->take_record(); }

}  // namespace floeplan::simulation
