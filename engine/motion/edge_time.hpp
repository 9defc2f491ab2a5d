#pragma once

#include <cmath>
#include <concepts>
#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/motion/edge_drive.hpp"
#include "engine/motion/edge_piece.hpp"
#include "engine/motion/plane_current.hpp"
#include "engine/motion/plane_edge.hpp"
#include "engine/motion/runge_kutta.hpp"
#include "engine/motion/sampled_line.hpp"

namespace floeplan::motion {

/// How exactly to integrate.
struct EdgeAccuracy {
  double relative_tolerance{1e-4};  // of the travel time
  // The scales on which a current changes that is known point by point only.
  core::Metres longest_step{INFINITY};  // on the ground
  core::Seconds longest_duration{INFINITY};
};

/// Below this tolerance the formula of higher order takes less work than the other.
inline constexpr double tight_tolerance = 2e-6;

/// A current that lays itself along an edge, stretch by stretch.
template <class F>
concept LaidOutCurrent = requires(const F& current, const PlaneEdge& edge, core::Seconds depart) {
  { current.line(edge).begin(depart) } -> std::same_as<bool>;
};

/// Travel time along an edge: the solution of ds/dt = v(x(s), t) from the departure on, where v = c.e +
/// sqrt(V^2 - (c.n)^2) is the speed over ground on the edge's direction e. Two vehicles on one edge obey the
/// same scalar equation, and solutions of a scalar equation do not cross: the later one never overtakes.
/// Hence FIFO: t1 <= t2 implies t1 + w(t1) <= t2 + w(t2), while the edge stays passable.
/// `visit_piece` sees the drive as it is integrated, up to the arrival, and may close the edge.
/// Accuracy relative error below the tolerance. Laid-out currents: open or closed is decided everywhere on
///          the way, to 1e-7 m/s of current; others: to what can be seen on the scales that `accuracy` states
/// Errors   the reason why the edge is closed: where the vehicle would be, when it would be there; too_late
///          as soon as it is certain that the arrival is after `latest`; what `visit_piece` answered
/// Source   Eichhorn 2009, section III.C (wfunc)
template <PlaneCurrent Current, EdgePieceVisitor VisitPiece = VisitNoPiece>
tl::expected<core::Seconds, EdgeClosed> edge_time(const PlaneEdge& edge, core::Seconds depart,
                                                  core::MetresPerSecond through_water, const Current& current,
                                                  const EdgeAccuracy& accuracy,
                                                  core::Seconds latest = core::Seconds{INFINITY},
                                                  const VisitPiece& visit_piece = {}) {
  if (!(edge.ground_length.value > 0.0)) return core::Seconds{0.0};

  const auto drive = [&]<class Line>(Line line) {
    if (accuracy.relative_tolerance < tight_tolerance) {
      return EdgeDrive<DormandPrince, Line>{line, edge.ground_length, through_water,
                                            accuracy.relative_tolerance}
          .run(depart, latest, visit_piece);
    }
    return EdgeDrive<BogackiShampine, Line>{line, edge.ground_length, through_water,
                                            accuracy.relative_tolerance}
        .run(depart, latest, visit_piece);
  };
  if constexpr (LaidOutCurrent<Current>) {
    return drive(current.line(edge));
  } else {
    return drive(SampledLine{edge, current, accuracy.longest_step, accuracy.longest_duration});
  }
}

}  // namespace floeplan::motion
