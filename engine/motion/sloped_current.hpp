#pragma once

#include <concepts>
#include <optional>

#include "engine/motion/plane_current.hpp"

namespace floeplan::motion {

/// A current and its derivatives in place; dx_dy is the derivative of the x component along y. Derivatives in
/// 1/s.
struct SlopedCurrent {
  CurrentXy velocity;
  double dx_dx{};
  double dx_dy{};
  double dy_dx{};
  double dy_dy{};
};

/// The current and its derivatives at a point of the plane at a time; empty: unknown.
/// Law      the velocity in `slopes_at` equals that of the plane current itself
template <class F>
concept SlopedPlaneCurrent =
    PlaneCurrent<F> && requires(const F& current, geo::PlanePoint point, core::Seconds time) {
      { current.slopes_at(point, time) } -> std::convertible_to<std::optional<SlopedCurrent>>;
    };

}  // namespace floeplan::motion
