#include "engine/avoidance/avoidance_system.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/avoidance/collision_watch.hpp"
#include "engine/avoidance/evasive_path.hpp"
#include "engine/avoidance/goal_point.hpp"
#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double reach_m = 700.0;     // objects farther away are tracked but not avoided
constexpr double slowest_m_s = 0.05;  // a slower reported speed is sensor noise, not a glider's
constexpr double path_point_reached_m = 8.0;
constexpr double path_kept = 0.8;    // of the clearance: a path this clear is still followed
constexpr double left_clear = 1.15;  // of the clearance: a route this clear is returned to
constexpr double progress_m = 50.0;
constexpr double farther_on_m = 150.0;  // along the route: second rendezvous if no path leads to the first

AvoidanceSettings checked(AvoidanceSettings settings) {
  const core::Violations violations = settings.violations();
  if (violations.empty()) return settings;
  throw std::invalid_argument{violations.front().field + " " + violations.front().rule};
}

bool is_usable_state(const OwnState& own, std::optional<core::UtcTime> last) {
  const bool is_finite = std::isfinite(core::unix_seconds(own.time)) && std::isfinite(own.place.x_m) &&
                         std::isfinite(own.place.y_m) && std::isfinite(own.depth.value) &&
                         std::isfinite(own.attitude.heading.value) &&
                         std::isfinite(own.attitude.pitch.value) && std::isfinite(own.attitude.roll.value) &&
                         std::isfinite(own.through_water.value);
  return is_finite && !(last && own.time < *last);
}

/// The part of a way up to this time.
TimedWay until(const TimedWay& way, double end_s) {
  TimedWay beginning;
  for (const TimedPoint& point : way.points()) {
    if (point.time_s <= end_s || beginning.empty()) {
      beginning.add(point);
      continue;
    }
    const TimedPoint& last = beginning.points().back();
    const double share = (end_s - last.time_s) / (point.time_s - last.time_s);
    beginning.add({{last.place.x_m + share * (point.place.x_m - last.place.x_m),
                    last.place.y_m + share * (point.place.y_m - last.place.y_m)},
                   end_s});
    break;
  }
  return beginning;
}

/// Whether the vehicle is at or abeam of a point of its path. Precondition: not the first point.
bool is_passed(std::span<const TimedPoint> path, std::size_t point, geo::PlanePoint own) {
  const geo::PlanePoint at = path[point].place;
  const geo::PlanePoint from = path[point - 1].place;
  const double ahead = (at.x_m - own.x_m) * (at.x_m - from.x_m) + (at.y_m - own.y_m) * (at.y_m - from.y_m);
  return ahead <= 0.0 || distance_m(own, at) < path_point_reached_m;
}

}  // namespace

AvoidanceSystem::AvoidanceSystem(std::vector<geo::PlanePoint> waypoints, CarriedForecast forecast,
                                 AvoidanceSettings settings)
    : settings_{checked(settings)},
      forecast_{std::move(forecast)},
      route_{std::move(waypoints), settings.waypoint_radius},
      current_{forecast_, settings.deepest, settings.forecast_sigma},
      objects_{settings_},
      room_{settings_},
      gradient_lines_{settings_} {}

Guidance AvoidanceSystem::step(const Sensed& sensed, const std::stop_token& stop) {
  const Guidance guided = react(sensed);
  if (path_wanted_) plan_path(stop);
  return guided;
}

Guidance AvoidanceSystem::react(const Sensed& sensed) {
  path_wanted_ = false;
  if (!is_usable_state(sensed.own, last_time_)) {
    Guidance held = last_;
    held.reason = Reason::own_state_unusable;
    return held;
  }
  last_time_ = sensed.own.time;
  perceive(sensed);
  route_.skip_to(own_.waypoint);
  last_ = guide();
  return last_;
}

/// Decides what to do from what was sensed so far.
Guidance AvoidanceSystem::guide() {
  if (own_.at_surface) {
    route_clear_since_s_.reset();
    reacted_s_.reset();
    return {.mode = mode_, .reason = Reason::at_surface, .waypoint = route_.next()};
  }

  const TimedWay route = route_.way(going_, water_, settings_.watch.count());
  const TimedWay path = path_from_here();
  const double clearance_m = settings_.clearance.value;
  const bool on_route = mode_ == Mode::mission;
  const bool route_clear =
      !first_contact(route.points(), obstacles_.all(), on_route ? clearance_m : left_clear * clearance_m);
  const bool path_clear =
      !path.empty() && !first_contact(path.points(), obstacles_.all(), path_kept * clearance_m);

  Choice choice = choose(route_clear, path_clear);
  if (is_too_close(choice, route, path)) close_until_s_ = going_.time_s + settings_.settled.count();
  if (going_.time_s < close_until_s_) choice = {Mode::reactive, Reason::too_close};
  if (is_in_vain(choice)) choice = {Mode::given_up, why_in_vain()};

  if (mode_ == Mode::mission && choice.mode != Mode::mission) ++counters_.evasions;
  if (choice.mode == Mode::mission) {
    path_ = {};
    planned_s_.reset();
    gradient_lines_.release();
  }
  mode_ = choice.mode;
  want_path(route_clear, path_clear);
  return guidance(choice, path);
}

void AvoidanceSystem::perceive(const Sensed& sensed) {
  own_ = sensed.own;
  const double now_s = core::unix_seconds(own_.time);
  water_.step(own_);
  if (sensed.current) current_.take(*sensed.current, own_.place);
  current_now_ = current_.mean(own_.place, settings_.shallowest, settings_.deepest, own_.time);
  const double speed_m_s = own_.through_water.value;
  going_ = {own_.place, now_s, speed_m_s > slowest_m_s ? speed_m_s : settings_.through_water.value,
            current_now_.velocity};
  route_.visit(own_.place);
  room_.sound(own_, water_.own());
  objects_.advance(now_s);
  if (const auto shoal = room_.take_shoal()) {
    for (const Echo& patch : *shoal) objects_.add(patch, water_.own());
  }
  if (sensed.sonar) take_ping(*sensed.sonar, own_);
  room_.take_covers(objects_);
  room_.take_beds(objects_);
  obstacles_.collect(objects_, water_.own(), reach_m);
}

void AvoidanceSystem::take_ping(const SonarPing& ping, const OwnState& own) {
  std::size_t heard = 0;
  for (const SonarReturn& sonar : ping.returns) {
    if (heard == echoes_.size()) break;
    if (is_usable(sonar, settings_.sonar.reach))
      echoes_[heard++] = placed(sonar, own, water_.own(), settings_.sonar);
  }
  room_.begin_ping({echoes_.data(), heard});
  for (std::size_t i = 0; i < heard; ++i) passes_[i] = room_.passes(echoes_[i]);
  std::size_t count = 0;
  for (std::size_t i = 0; i < heard; ++i) {
    const Echo echo = echoes_[i];
    if (passes_[i] == VerticalRoom::Pass::above) objects_.stand_on(echo);
    if (passes_[i] == VerticalRoom::Pass::no) echoes_[count++] = echo;
  }
  objects_.take({echoes_.data(), count}, own, water_.own());
}

/// The rest of the path from the vehicle's place, at its present speed.
TimedWay AvoidanceSystem::path_from_here() const {
  TimedWay way;
  const auto points = path_.points();
  if (path_point_ >= points.size()) return way;
  way.add({water_.own(), going_.time_s});
  for (std::size_t i = path_point_; i < points.size(); ++i) {
    const TimedPoint& last = way.points().back();
    const double length_m = distance_m(last.place, points[i].place);
    if (length_m > 0.0) way.add({points[i].place, last.time_s + length_m / going_.through_water_m_s});
  }
  return way;
}

AvoidanceSystem::Choice AvoidanceSystem::choose(bool route_clear, bool path_clear) {
  if (!route_clear) {
    route_clear_since_s_.reset();
  } else if (!route_clear_since_s_) {
    route_clear_since_s_ = going_.time_s;
  }
  const bool settled =
      route_clear_since_s_ && going_.time_s - *route_clear_since_s_ >= settings_.settled.count();
  if (route_clear && (mode_ == Mode::mission || settled)) return {Mode::mission, Reason::route_clear};
  if (path_clear) return {Mode::path, Reason::evading};
  return {Mode::reactive, why_no_path_};
}

/// Whether reactive control must steer: something is close, or soon will be on the chosen course.
bool AvoidanceSystem::is_too_close(const Choice& choice, const TimedWay& route, const TimedWay& path) const {
  const double close_m = settings_.close.value;
  const auto nearest = obstacles_.nearest_m(water_.own());
  if (nearest && *nearest < close_m) return true;
  const double soon_s = going_.time_s + settings_.imminent.count();
  const TimedWay steered = until(choice.mode == Mode::path ? path : route, soon_s);
  return choice.mode != Mode::reactive &&
         first_contact(steered.points(), obstacles_.all(), close_m).has_value();
}

/// Whether evasion has made no progress for too long. Time on the mission's own route does not count as
/// evasion.
bool AvoidanceSystem::is_in_vain(const Choice& choice) {
  if (mode_ == Mode::given_up) return true;
  const double to_go_m = route_.to_go_m(own_.place);
  if (!reacted_s_ || route_.is_done() || to_go_m < least_to_go_m_ - progress_m) {
    least_to_go_m_ = reacted_s_ ? to_go_m : std::max(to_go_m, least_to_go_m_);
    in_vain_s_ = 0.0;
  } else if (choice.mode != Mode::mission) {
    in_vain_s_ += going_.time_s - *reacted_s_;
  }
  reacted_s_ = going_.time_s;
  return in_vain_s_ >= settings_.give_up.count();
}

Reason AvoidanceSystem::why_in_vain() const {
  if (route_.is_done()) return Reason::no_progress;
  const double course = direction_rad(own_.place, route_.waypoints()[route_.next()]);
  const Crab against = crab(course, going_.current, going_.through_water_m_s);
  return against.speed_m_s < slowest_m_s ? Reason::current_too_strong : Reason::no_progress;
}

void AvoidanceSystem::want_path(bool route_clear, bool path_clear) {
  if (mode_ == Mode::mission || mode_ == Mode::given_up || route_.is_done()) return;
  const bool is_due = !planned_s_ || going_.time_s - *planned_s_ >= settings_.replan.count();
  path_wanted_ = is_due && !path_clear && !route_clear;
}

void AvoidanceSystem::plan_path(const std::stop_token& stop) {
  path_wanted_ = false;
  planned_s_ = going_.time_s;
  path_ = {};
  for (const double least_m : {0.0, farther_on_m}) {
    const auto goal = rendezvous(route_, going_, water_, obstacles_.all(), settings_, least_m);
    if (!goal) {
      why_no_path_ = Reason::goal_occupied;
      break;
    }
    const EvasivePath planned = plan_evasion(going_, goal->place, water_, obstacles_.all(), settings_, stop);
    counters_.most_expansions = std::max(counters_.most_expansions, planned.expansions);
    if (planned.way.empty()) {
      ++counters_.paths_failed;
      why_no_path_ = Reason::no_path;
      continue;
    }
    ++counters_.paths_planned;
    path_ = planned.way;
    path_point_ = 1;
    why_no_path_ = Reason::path_not_ready;
    route_.skip_to(goal->waypoint);
    return;
  }
}

Guidance AvoidanceSystem::guidance(const Choice& choice, const TimedWay& path) {
  Guidance guided{.mode = choice.mode, .reason = choice.reason, .waypoint = route_.next()};
  guided.shallowest = room_.shallowest();
  guided.deepest = room_.deepest();
  if (choice.mode == Mode::mission) return guided;
  if (choice.mode == Mode::path) {
    const auto points = path.points();
    guided.heading =
        core::Radians{direction_rad(water_.own(), points.size() > 1 ? points[1].place : water_.own())};
    const auto planned = path_.points();
    while (path_point_ < planned.size() && is_passed(planned, path_point_, water_.own())) ++path_point_;
    return guided;
  }
  Crab to_goal{own_.attitude.heading.value, going_.through_water_m_s};
  double goal_s = settings_.watch.count();
  if (choice.mode == Mode::reactive && !route_.is_done()) {
    const geo::PlanePoint goal = route_.waypoints()[route_.next()];
    to_goal = crab(direction_rad(own_.place, goal), going_.current, going_.through_water_m_s);
    goal_s = distance_m(own_.place, goal) / std::max(to_goal.speed_m_s, slowest_m_s);
  }
  const GradientCourse course = gradient_lines_.steer(water_.own(), going_.through_water_m_s,
                                                      to_goal.heading_rad, goal_s, obstacles_.all());
  guided.heading = core::Radians{course.heading_rad};
  guided.thruster = course.boxed_in || choice.reason == Reason::too_close;
  if (course.boxed_in) guided.reason = Reason::boxed_in;
  return guided;
}

std::vector<DetectedObject> AvoidanceSystem::objects() const {
  std::vector<DetectedObject> list;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const TrackedObject& object = objects_[i];
    const geo::PlaneVelocity drift = object.drift();
    list.push_back(
        {.id = object.id(),
         .centre = water_.to_local(object.centre()),
         .half_extent = core::Metres{object.half_extent_m()},
         .place_sigma = core::Metres{object.place_sigma_m()},
         .drift = {{drift.x_m_s + going_.current.east.value}, {drift.y_m_s + going_.current.north.value}},
         .drift_sigma = core::MetresPerSecond{object.drift_sigma_m_s()},
         .keel = core::Metres{object.keel_m()},
         .unseen = core::Seconds{going_.time_s - object.seen_s()}});
  }
  return list;
}

}  // namespace floeplan::avoidance
