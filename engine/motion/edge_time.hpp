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

/// Accuracy of the integration.
struct EdgeAccuracy {
  double relative_tolerance{1e-4};  // of the travel time
  // For currents known point by point: the scales on which they change.
  core::Metres longest_step{INFINITY};  // on the ground
  core::Seconds longest_duration{INFINITY};
};

/// Below this tolerance the formula of higher order needs less work than the other one.
inline constexpr double tight_tolerance = 2e-6;

/// A current that provides a line of stretches along an edge.
template <class F>
concept LaidOutCurrent = requires(const F& current, const PlaneEdge& edge, core::Seconds depart) {
  { current.line(edge).begin(depart) } -> std::same_as<bool>;
};

/// Travel time along an edge: the solution of ds/dt = v(x(s), t) from the departure on. The speed over ground
/// in the edge's direction e is v = c.e + sqrt(V^2 - (c.n)^2). Two vehicles on one edge obey the same scalar
/// equation, and solutions of a scalar equation do not cross: the later vehicle never overtakes. Hence FIFO:
/// t1 <= t2 implies t1 + w(t1) <= t2 + w(t2), while the edge stays passable.
/// `visit_piece` gets the pieces of the drive up to the arrival, and may close the edge.
/// Accuracy relative error below the tolerance. Laid-out currents: open or closed is decided everywhere on
/// the way, to 1e-7 m/s of current; others: to what can be seen on the scales that `accuracy` states
/// Errors   why the edge is closed at the place and time of the vehicle; too_late as soon as the arrival is
///          certainly after `latest`; the result of `visit_piece`
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
