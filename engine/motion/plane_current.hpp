#pragma once

#include <concepts>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::motion {

/// Current along the axes of a plane, in m/s on the ground.
struct CurrentXy {
  double x_m_s{};
  double y_m_s{};
};

/// The current at a point of the plane at a time, counted from an instant that the caller chooses; empty:
/// unknown.
/// Law      equal arguments give equal results
template <class F>
concept PlaneCurrent = requires(const F& current, geo::PlanePoint point, core::Seconds time) {
  { current(point, time) } -> std::convertible_to<std::optional<CurrentXy>>;
};

}  // namespace floeplan::motion
