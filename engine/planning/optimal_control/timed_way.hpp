#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::optimal_control {

/// The travel time of a straight leg for a departure at `depart`; empty: the leg cannot be travelled then.
using LegTimer = std::function<std::optional<core::Seconds>(geo::PlanePoint from, geo::PlanePoint to,
                                                            core::Seconds depart)>;

/// A route of straight legs, and the time at each point. The first time is the departure.
struct TimedWay {
  std::vector<geo::PlanePoint> points;
  std::vector<core::Seconds> times;

  [[nodiscard]] core::Seconds duration() const { return times.back() - times.front(); }
  /// The place of the vehicle at a time, at constant speed along each leg. Before the departure it is the
  /// start, after the arrival the goal.
  [[nodiscard]] geo::PlanePoint at(core::Seconds time) const;
};

/// Times a route leg by leg; empty when a leg cannot be travelled.
[[nodiscard]] std::optional<TimedWay> time_way(std::vector<geo::PlanePoint> points, core::Seconds depart,
                                               const LegTimer& leg_timer);

/// Points on the route at equal time steps, both ends included. Legs between these points cut the route's
/// corners.
[[nodiscard]] std::vector<geo::PlanePoint> cut_evenly(const TimedWay& way, std::size_t legs);

}  // namespace floeplan::planning::optimal_control
