#pragma once

#include <concepts>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::planning {

/// Travel time of the straight leg from a to b when leaving a at `depart`; empty, or an error: it is closed
/// then.
/// Law  the same arguments give the same answer
template <class F>
concept LegTime = requires(const F& leg_time, geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) {
  { leg_time(a, b, depart).has_value() } -> std::same_as<bool>;
  { *leg_time(a, b, depart) } -> std::convertible_to<core::Seconds>;
};

}  // namespace floeplan::planning
