#pragma once

#include <concepts>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::motion {

/// Current along the axes of a plane, metres on the ground for each second.
struct CurrentXy {
  double x_m_s{};
  double y_m_s{};
};

/// The current at a point of the plane at a time (counted from an instant that the caller chose); empty: not
/// known there.
/// Law      the same arguments give the same answer
template <class F>
concept PlaneCurrent = requires(const F& current, geo::PlanePoint point, core::Seconds time) {
  { current(point, time) } -> std::convertible_to<std::optional<CurrentXy>>;
};

}  // namespace floeplan::motion
