#include "engine/simulation/flight/mission_pilot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/messages/flight_messages.hpp"
#include "engine/motion/waypoint_heading.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::simulation {
namespace {

using Cause = SurfaceOrders::Cause;

/// Time for a second fix at the end of a surfacing. With the first fix it gives the drift.
/// Source   gps_postfix_wait_time of the vendor's data dictionary of firmware 10.5
constexpr core::Seconds postfix{60.0};

/// Height of the saw-tooth of a vehicle that waits below ice until it can surface.
constexpr double held_tooth_m = 10.0;

/// Time until pump and pitch have turned a shallow vehicle (HullMotion). The vehicle does not turn again earlier.
/// Between sea bed and surface without room it would otherwise turn every second and drain its battery.
constexpr core::Seconds turning_time{15.0};

/// A vehicle that changes its depth by less does not saw-tooth and makes no way.
constexpr core::Metres same_depth = vehicle::lowest_tooth;

/// After this time of searching a lead the vehicle returns to its last place at the surface. Half an hour of
/// drifting floes is enough to tell a lead from closed ice.
constexpr core::Seconds looks_for_a_lead{1800.0};

double level_distance(Vector a, Vector b) { return std::hypot(a.east - b.east, a.north - b.north); }

}  // namespace

MissionPilot::MissionPilot(const MissionOrders& orders, FlightPath path, core::Seconds first_fix,
                           core::UtcTime start)
    : orders_{orders},
      path_{std::move(path)},
      first_fix_{first_fix},
      surfaced_{start},
      fix_due_{start},
      leave_{start},
      last_contact_{start},
      began_(orders.surfaces.size(), start),
      ended_(orders.surfaces.size(), start) {}

MissionPilot::Turned MissionPilot::step(const Known& known, const avoidance::Guidance& guidance) {
  if (phase_ == Phase::done) return {};
  if (phase_ == Phase::at_surface) return at_surface(known);

  Turned turned;
  if (phase_ == Phase::surfacing) {
    keep_below_ice(known, guidance);
    if (!known.floats) return turned;
    phase_ = Phase::at_surface;
    surfaced_ = known.time;
    fix_due_ = known.time + first_fix_;
    leave_ = fix_due_ + std::max(wait_, postfix);
    fixed_ = false;
    turned.surfaced = true;
    return turned;
  }
  pass_waypoints(known, guidance, turned);
  turn(known, guidance, turned);
  if (orders_.overdepth && known.place.down > orders_.overdepth->value) {
    abort(messages::flight_text<"aborted-too-deep">());
  } else if (guidance.mode == avoidance::Mode::given_up) {
    abort(messages::flight_text<"aborted-by-avoidance">(avoidance::text(guidance.reason)));
  } else if (is_held_at_one_depth(known)) {
    abort(messages::flight_text<"aborted-at-one-depth">());
  } else if (!has_no_heading() && orders_.max_waypoint &&
             level_distance(path_.stops[stop_].place, known.place) > orders_.max_waypoint->value) {
    abort(messages::flight_text<"aborted-far-waypoint">());
  } else {
    seek_surface(known, turned.waypoint.has_value());
  }
  return turned;
}

MissionPilot::Turned MissionPilot::at_surface(const Known& known) {
  Turned turned;
  if (!fixed_ && known.time >= fix_due_) {
    fixed_ = true;
    turned.fixed = true;
    last_contact_ = known.time;
  }
  if (!fixed_ || known.time < leave_) return turned;

  if (running_) {
    turned.fixed = true;
    ended_[*running_] = known.time;
    running_.reset();
  }
  last_contact_ = known.time;
  if (ends_) {
    phase_ = Phase::done;
    return turned;
  }
  end_hold_in_time(known.time);
  if (std::exchange(awaits_list_, false)) halves_ = 0;
  phase_ = Phase::diving;
  open_water_ = known.place;
  turns_back_ = false;
  below_ice_since_.reset();
  turns_ = 0;
  held_since_ = known.time;
  turned.dived = true;
  return turned;
}

void MissionPilot::end_hold_in_time(core::UtcTime time) {
  const auto hold = has_finished() ? std::nullopt : path_.stops[stop_].hold;
  if (!hold) {
    left_to_hold_.reset();
    return;
  }
  const core::Seconds between = left_to_hold_ ? time - *left_to_hold_ : core::Seconds{0.0};
  left_to_hold_ = time;
  if (time + 0.5 * between < hold->planned) return;
  stop_ = hold->next;
  left_to_hold_.reset();
}

void MissionPilot::pass_waypoints(const Known& known, const avoidance::Guidance& guidance, Turned& turned) {
  const auto pass = [&] {
    awaits_list_ = awaits_list_ || path_.stops[stop_].ends_list;
    ++stop_;
  };
  if (guidance.mode != avoidance::Mode::mission) {
    while (!has_finished() && stop_ < guidance.waypoint) pass();
  }
  while (!has_no_heading() &&
         level_distance(path_.stops[stop_].place, known.place) < path_.stops[stop_].radius_m) {
    turned.waypoint = stop_;
    pass();
    if (has_finished() && path_.loops_to) {
      stop_ = *path_.loops_to;
      return;
    }
  }
}

void MissionPilot::turn(const Known& known, const avoidance::Guidance& guidance, Turned& turned) {
  if (known.time - turned_ < turning_time) return;
  const double depth_m = known.place.down;
  if (phase_ == Phase::diving) {
    const HalfYo& dive = orders_.yo.dive;
    const bool deep = depth_m >= dive.depth.value || (guidance.deepest && depth_m >= guidance.deepest->value);
    const bool low = dive.altitude && known.altitude && *known.altitude <= *dive.altitude;
    turned.inflected = deep || low;
    if (turned.inflected) phase_ = Phase::climbing;
  } else if (phase_ == Phase::climbing) {
    const double shallowest_m =
        std::max(orders_.yo.climb.depth.value, guidance.shallowest.value_or(core::Metres{0.0}).value);
    turned.inflected = depth_m <= shallowest_m;
    if (turned.inflected) phase_ = Phase::diving;
  }
  if (turned.inflected) {
    turned_ = known.time;
    ++halves_;
    ++turns_;
  }
}

bool MissionPilot::is_due(const SurfaceOrders& orders, std::size_t index, const Known& known,
                          bool hit_waypoint) const {
  const bool yo_ended = orders_.yo.half_cycles >= 0 && halves_ >= orders_.yo.half_cycles;
  switch (orders.cause) {
    case Cause::any_idle: return has_no_heading() || yo_ended;
    case Cause::yo_idle: return yo_ended;
    case Cause::list_idle: return has_no_heading();
    case Cause::after_end: return known.time - ended_[index] >= orders.interval;
    case Cause::near_waypoint:
      return !has_no_heading() &&
             level_distance(path_.stops[stop_].place, known.place) < orders.distance.value;
    case Cause::waypoint_hit: return hit_waypoint;
    case Cause::every: return known.time - began_[index] >= orders.interval;
    case Cause::no_contact: return known.time - last_contact_ >= orders.interval;
    case Cause::inflections: return orders.turns >= 0 && turns_ > orders.turns;
  }
  return false;
}

void MissionPilot::seek_surface(const Known& known, bool hit_waypoint) {
  for (std::size_t i = 0; i < orders_.surfaces.size(); ++i) {
    if (is_due(orders_.surfaces[i], i, known, hit_waypoint))
      return come_up(orders_.surfaces[i], i, known.time);
  }
  if (has_no_heading()) {
    abort(messages::flight_text<"aborted-without-heading">());
    ends_ = has_finished();
    return;
  }
  if (orders_.yo.half_cycles >= 0 && halves_ >= orders_.yo.half_cycles)
    abort(messages::flight_text<"aborted-without-pitch">());
}

void MissionPilot::come_up(const SurfaceOrders& orders, std::size_t index, core::UtcTime time) {
  phase_ = Phase::surfacing;
  running_ = index;
  began_[index] = time;
  climb_ = orders.climb;
  wait_ = orders.wait;
  // After the last list no orders remain, whether the pilot answers or not.
  ends_ = has_finished() || (orders.ends_mission && !awaits_list_);
  if (orders_.yo.half_cycles >= 0 && halves_ >= orders_.yo.half_cycles) halves_ = 0;
  if (has_finished()) {
    reason_ = messages::flight_text<"flight-arrived">();
  } else if (ends_) {
    reason_ = messages::flight_text<"flight-ended-by-surfacing">();
  }
}

void MissionPilot::abort(std::string reason) {
  phase_ = Phase::surfacing;
  climb_ = orders_.yo.climb;
  wait_ = core::Seconds{0.0};
  ends_ = true;
  reason_ = std::move(reason);
}

bool MissionPilot::is_held_at_one_depth(const Known& known) {
  if (std::abs(known.place.down - held_depth_m_) > same_depth.value) {
    held_depth_m_ = known.place.down;
    held_since_ = known.time;
  }
  return orders_.same_depth && known.time - held_since_ >= *orders_.same_depth;
}

/// A vehicle that is to surface below ice continues its saw-tooth below the ice until there is none above.
void MissionPilot::keep_below_ice(const Known& known, const avoidance::Guidance& guidance) {
  if (!guidance.shallowest) {
    below_ice_since_.reset();
    held_down_ = false;
    return;
  }
  if (!below_ice_since_) {
    below_ice_since_ = known.time;
  } else if (known.time - *below_ice_since_ >= looks_for_a_lead && !turns_back_) {
    turns_back_ = true;
    reason_ += " " + messages::flight_text<"turned-back-below-ice">();
  }
  if (known.place.down <= guidance.shallowest->value) {
    held_down_ = true;
  } else if (known.place.down >= guidance.shallowest->value + held_tooth_m) {
    held_down_ = false;
  }
}

const HalfYo& MissionPilot::half() const {
  if (phase_ == Phase::diving || (phase_ == Phase::surfacing && held_down_)) return orders_.yo.dive;
  if (phase_ == Phase::climbing) return orders_.yo.climb;
  return climb_;
}

bool MissionPilot::uses_thruster(const avoidance::Guidance& guidance) const {
  if (phase_ == Phase::at_surface || phase_ == Phase::done) return false;
  return guidance.thruster || half().thruster;
}

Vector MissionPilot::goal() const {
  if (phase_ == Phase::surfacing && turns_back_) return open_water_;
  return path_.stops[has_no_heading() ? stop_ - 1 : stop_].place;
}

ActuatorTargets MissionPilot::targets(const Known& known, const avoidance::Guidance& guidance) const {
  ActuatorTargets targets;
  if (phase_ == Phase::at_surface || phase_ == Phase::done) {
    targets.buoyancy_m3 = orders_.yo.climb.buoyancy_m3;
    return targets;
  }
  targets.pitch_rad = half().pitch_rad;
  targets.buoyancy_m3 = half().buoyancy_m3;
  if (guidance.heading) {
    targets.heading_rad = guidance.heading->value;
    return targets;
  }
  const Vector goal = this->goal();
  const auto heading_rad =
      motion::waypoint_heading(goal.east - known.place.east, goal.north - known.place.north, known.speed_m_s,
                               known.current.east, known.current.north);
  targets.heading_rad = heading_rad.value_or(targets.heading_rad);
  return targets;
}

}  // namespace floeplan::simulation
