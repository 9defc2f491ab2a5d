#pragma once

#include <concepts>
#include <optional>

#include "engine/motion/edge_closed.hpp"

namespace floeplan::motion {

/// A part of the drive along an edge: the distance s(t) is the cubic with these values and slopes at its two
/// ends.
/// Units    metres on the ground from the edge's start; seconds on the clock of the departure
struct EdgePiece {
  double t0_s{};
  double way0_m{};
  double v0_m_s{};
  double t1_s{};
  double way1_m{};
  double v1_m_s{};
};

/// Called with each piece of the drive, in order and without gaps; a non-empty result closes the edge.
template <class F>
concept EdgePieceVisitor = requires(const F& visit, const EdgePiece& piece) {
  { visit(piece) } -> std::convertible_to<std::optional<EdgeClosed>>;
};

/// Visitor that does nothing.
struct VisitNoPiece {
  std::optional<EdgeClosed> operator()(const EdgePiece&) const { return std::nullopt; }
};

}  // namespace floeplan::motion
