#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::optimal_control {

/// Travel time of a straight leg that is left at `depart`; empty: it cannot be travelled then.
using LegTimer = std::function<std::optional<core::Seconds>(geo::PlanePoint from, geo::PlanePoint to,
                                                            core::Seconds depart)>;

/// A way of straight legs and the times at its points, the departure first.
struct TimedWay {
  std::vector<geo::PlanePoint> points;
  std::vector<core::Seconds> times;

  [[nodiscard]] core::Seconds duration() const { return times.back() - times.front(); }
  /// Where the vehicle is at a time, held to the ends of the way; at a steady pace along each leg.
  [[nodiscard]] geo::PlanePoint at(core::Seconds time) const;
};

/// Times a way leg by leg; empty when a leg cannot be travelled.
[[nodiscard]] std::optional<TimedWay> time_way(std::vector<geo::PlanePoint> points, core::Seconds depart,
                                               const LegTimer& leg_timer);

/// Points on the way at equal steps of time, both ends included: that many legs, which cut corners.
[[nodiscard]] std::vector<geo::PlanePoint> cut_evenly(const TimedWay& way, std::size_t legs);

}  // namespace floeplan::planning::optimal_control
