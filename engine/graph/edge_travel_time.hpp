#pragma once

#include <concepts>

#include "engine/core/units.hpp"
#include "engine/graph/grid_graph.hpp"

namespace floeplan::graph {

/// Travel time of `edge` for a departure from its tail at `depart` (wfunc in the paper); empty: not passable
/// then. Positive. Times count from an instant that the caller chooses.
/// `latest`: later arrivals are of no use, so the function may return empty without computing the time.
/// Law (FIFO): leaving later never arrives earlier. Edges that reopen and moving obstacles break it.
template <class F>
concept EdgeTravelTime = requires(const F& f, const Edge& edge, core::Seconds depart, core::Seconds latest) {
  { f(edge, depart, latest).has_value() } -> std::same_as<bool>;
  { *f(edge, depart, latest) } -> std::convertible_to<core::Seconds>;
};

}  // namespace floeplan::graph
