#pragma once

#include <concepts>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::planning::cost {

/// Time and cost of a straight leg.
struct LegCost {
  core::Seconds time{};
  double cost{};  // in the unit of the objective
};

/// Cost of a leg if the objective is time alone: one unit per second.
[[nodiscard]] inline LegCost cost_of_leg(core::Seconds time) { return {time, time.count()}; }
[[nodiscard]] inline LegCost cost_of_leg(const LegCost& leg) { return leg; }

/// Travel time, or time and cost, of the straight leg from a to b with departure from a at `depart`. Empty, or an
/// error, if the leg is closed at that time.
/// Law  the same arguments give the same answer
template <class F>
concept CostedLeg = requires(const F& leg, geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) {
  { leg(a, b, depart).has_value() } -> std::same_as<bool>;
  { cost_of_leg(*leg(a, b, depart)) } -> std::same_as<LegCost>;
};

}  // namespace floeplan::planning::cost
