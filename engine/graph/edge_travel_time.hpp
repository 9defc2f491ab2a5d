#pragma once

#include <concepts>

#include "engine/core/units.hpp"
#include "engine/graph/grid_graph.hpp"

namespace floeplan::graph {

/// Time to travel `edge` when leaving its tail at `depart` (wfunc in the paper); empty: not passable then.
/// Times are counted from an instant that the caller chose. An edge's time is positive.
/// `latest`: an arrival after it is of no use, so the function may then answer empty without working out the
/// time. Law (FIFO): leaving later never arrives earlier. Edges that open later and moving obstacles break
/// it.
template <class F>
concept EdgeTravelTime = requires(const F& f, const Edge& edge, core::Seconds depart, core::Seconds latest) {
  { f(edge, depart, latest).has_value() } -> std::same_as<bool>;
  { *f(edge, depart, latest) } -> std::convertible_to<core::Seconds>;
};

}  // namespace floeplan::graph
