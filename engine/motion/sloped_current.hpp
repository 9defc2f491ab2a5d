#pragma once

#include <concepts>
#include <optional>

#include "engine/motion/plane_current.hpp"

namespace floeplan::motion {

/// A current and how it changes from place to place; dx_dy is the slope of its x component along y. Slopes
/// per second.
struct SlopedCurrent {
  CurrentXy velocity;
  double dx_dx{};
  double dx_dy{};
  double dy_dx{};
  double dy_dy{};
};

/// The current and its slopes at a point of the plane at a time; empty: not known there.
/// Law      `slopes_at` gives the velocity that the plane current itself gives
template <class F>
concept SlopedPlaneCurrent =
    PlaneCurrent<F> && requires(const F& current, geo::PlanePoint point, core::Seconds time) {
      { current.slopes_at(point, time) } -> std::convertible_to<std::optional<SlopedCurrent>>;
    };

}  // namespace floeplan::motion
