#include "engine/mission/writing/hold_legs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/waypoint_heading.hpp"

namespace floeplan::mission {
namespace {

/// Time from surfacing to the next dive: a minute to the first fix, and the keystroke_wait_time that
/// flight_files writes. The vendor's stock missions have the same value.
constexpr double at_surface_s = 360.0;
constexpr double step_s = 5.0;
/// Time without headway at every turn of the saw-tooth. It takes 13 s to move the piston of a shallow vehicle
/// by twice 230 cm3 at 36 cm3/s, and 11 s until the hull has pitched over (logs of comet, 21 August 2019, and
/// amadeus, 24 July 2014).
constexpr double turn_s = 24.0;
constexpr int spacings = 30;               // number of row distances tried
constexpr double longer_s = 6.0 * 3600.0;  // the shortest list may exceed a hold by this
constexpr double near_wait = 0.01;
constexpr double far_from_wait = 0.05;
constexpr double least_radius_m = 10.0;  // minimum of list_when_wpt_dist in the vehicle's data dictionary
constexpr double usual_radius_m = 100.0;
constexpr double still_m2_s2 = 1e-6;  // a smaller sum of squares counts as no current
constexpr std::size_t fewest_legs = 3;
constexpr int enough_legs = 8;  // then a turn is within a sixteenth of the hold from its end

/// The current at a time; linear between the samples.
geo::VelocityEn current_at(const HoldFlight& flight, double time_s) {
  const auto& samples = flight.currents;
  if (samples.empty()) return {};
  const double last = static_cast<double>(samples.size() - 1);
  const double at = std::clamp(last * time_s / std::max(1.0, flight.wait.count()), 0.0, last);
  const auto before = static_cast<std::size_t>(at);
  const auto after = std::min(before + 1, samples.size() - 1);
  const double share = at - static_cast<double>(before);
  const auto mean = [share](core::MetresPerSecond a, core::MetresPerSecond b) {
    return core::MetresPerSecond{(1.0 - share) * a.value + share * b.value};
  };
  return {mean(samples[before].east, samples[after].east), mean(samples[before].north, samples[after].north)};
}

/// Axis of the rows: across the main axis of the currents, along which their sum of squares is largest.
geo::Bearing axis_of(const HoldFlight& flight) {
  double ee = 0.0;
  double nn = 0.0;
  double en = 0.0;
  for (const geo::VelocityEn& current : flight.currents) {
    ee += current.east.value * current.east.value;
    nn += current.north.value * current.north.value;
    en += current.east.value * current.north.value;
  }
  if (ee + nn < still_m2_s2) return geo::Bearing::towards(flight.course.north(), -flight.course.east());
  const double from_east_rad = 0.5 * std::atan2(2.0 * en, ee - nn);
  return geo::Bearing::towards(std::sin(from_east_rad), -std::cos(from_east_rad));
}

/// Simulates the vehicle between its two rows, steered as by its own computer.
class Shuttle {
 public:
  Shuttle(const HoldFlight& flight, geo::Bearing axis, core::Metres apart, core::Metres radius)
      : flight_{flight}, axis_{axis}, half_m_{0.5 * apart.value}, radius_m_{radius.value} {}

  /// For one leg, two legs and so on: the time in seconds from the arrival until the vehicle leaves after
  /// them. Ends at twice the wait plus a day.
  std::vector<double> ends() {
    std::vector<double> ends;
    // The phase of its dives at the arrival is unknown; half-way down is the average.
    time_s_ = 0.5 * flight_.band.bottom.value / flight_.vertical.value;
    stay_at_surface();
    bool comes_up = false;
    bool climbs = false;
    double next_up_s = flight_.between_surfacings.count();
    const double latest_s = 1.1 * flight_.wait.count() + longer_s;
    while (time_s_ < latest_s && ends.size() < most_hold_legs) {
      const double side = ends.size() % 2 == 0 ? -half_m_ : half_m_;
      const double gap_east_m = side * axis_.east() - east_m_;
      const double gap_north_m = side * axis_.north() - north_m_;
      if (!comes_up && std::hypot(gap_east_m, gap_north_m) < radius_m_) {
        ends.push_back(time_s_ + depth_m_ / flight_.vertical.value + at_surface_s);
        comes_up = flight_.surfaces;
        continue;
      }
      if (flight_.surfaces && !comes_up && time_s_ >= next_up_s) {
        comes_up = true;
        next_up_s = time_s_ + flight_.between_surfacings.count();
      }
      if (comes_up && depth_m_ <= 0.0) {
        comes_up = false;
        climbs = false;
        stay_at_surface();
        continue;
      }
      turn(comes_up || climbs);
      steer(gap_east_m, gap_north_m);
      if (depth_m_ >= flight_.band.bottom.value) climbs = true;
      if (depth_m_ <= flight_.band.top.value) climbs = false;
    }
    return ends;
  }

 private:
  void drift(const geo::VelocityEn& current, double time_s) {
    east_m_ += current.east.value * time_s;
    north_m_ += current.north.value * time_s;
    time_s_ += time_s;
  }

  void stay_at_surface() {
    depth_m_ = 0.0;
    rises_ = true;
    drift(current_at(flight_, time_s_), at_surface_s);
  }

  /// Turns in the saw-tooth, upwards or downwards.
  void turn(bool up) {
    if (std::exchange(rises_, up) != up) drift(current_at(flight_, time_s_), turn_s);
  }

  void steer(double gap_east_m, double gap_north_m) {
    const geo::VelocityEn current = current_at(flight_, time_s_);
    const double heading_rad = motion::waypoint_heading(gap_east_m, gap_north_m, flight_.speed.value,
                                                        current.east.value, current.north.value)
                                   .value_or(0.0);
    east_m_ += flight_.speed.value * std::sin(heading_rad) * step_s;
    north_m_ += flight_.speed.value * std::cos(heading_rad) * step_s;
    depth_m_ += (rises_ ? -1.0 : 1.0) * flight_.vertical.value * step_s;
    drift(current, step_s);
  }

  const HoldFlight& flight_;
  geo::Bearing axis_;
  double half_m_;
  double radius_m_;
  double time_s_{};
  double east_m_{};
  double north_m_{};
  double depth_m_{};
  bool rises_{true};
};

/// All lists that are candidates, those with the longest legs first.
std::vector<HoldLegs> tried_lists(const HoldFlight& flight) {
  const geo::Bearing axis = axis_of(flight);
  const core::Metres radius = turning_radius(flight.circle);
  std::vector<HoldLegs> lists;
  const core::Metres widest = 2.0 * flight.circle;
  const core::Metres step = (1.0 / spacings) * (widest - 4.0 * radius);
  for (int i = 0; i <= spacings; ++i) {
    const core::Metres apart = widest - static_cast<double>(i) * step;
    const std::vector<double> ends = Shuttle{flight, axis, apart, radius}.ends();
    for (std::size_t count = fewest_legs; count <= ends.size(); ++count)
      lists.push_back({axis, apart, radius, static_cast<int>(count), core::Seconds{ends[count - 1]}});
  }
  return lists;
}

}  // namespace

core::Metres turning_radius(core::Metres circle) {
  return {std::floor(std::clamp(circle.value / 5.0, least_radius_m, usual_radius_m))};
}

std::optional<HoldLegs> hold_legs(const HoldFlight& flight) {
  const std::vector<HoldLegs> lists = tried_lists(flight);
  const auto off = [&](const HoldLegs& list) { return std::abs(list.expected / flight.wait - 1.0); };
  const auto is_worse = [&](const HoldLegs& a, const HoldLegs& b) {
    const bool is_near = off(a) <= near_wait;
    if (is_near != (off(b) <= near_wait)) return !is_near;
    if (!is_near || a.legs == b.legs) return off(a) > off(b);
    const bool has_enough = a.legs >= enough_legs;
    return has_enough == (b.legs >= enough_legs) ? (a.legs > b.legs) == has_enough : !has_enough;
  };
  const auto best = std::ranges::max_element(lists, is_worse);
  if (best != lists.end() && off(*best) <= far_from_wait) return *best;
  const bool is_short =
      !lists.empty() && flight.wait < std::ranges::min(lists, {}, &HoldLegs::expected).expected;
  if (is_short) return std::nullopt;
  if (!flight.surfaces && !lists.empty())
    return std::ranges::max(lists, {}, [&](const HoldLegs& list) {
      return list.expected <= flight.wait ? list.expected.count() : 0.0;
    });
  return HoldLegs{.axis = axis_of(flight),
                  .apart = 2.0 * flight.circle,
                  .radius = turning_radius(flight.circle),
                  .legs = -1,
                  .expected = flight.wait};
}

std::optional<core::Seconds> hold_time(const HoldFlight& flight, const HoldLegs& legs) {
  const std::vector<double> ends = Shuttle{flight, legs.axis, legs.apart, legs.radius}.ends();
  if (legs.legs < 1 || static_cast<std::size_t>(legs.legs) > ends.size()) return std::nullopt;
  return core::Seconds{ends[static_cast<std::size_t>(legs.legs) - 1]};
}

}  // namespace floeplan::mission
