#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/motion/plane_current.hpp"

namespace floeplan::motion {

/// A straight line in the plane and its length on the ground.
struct PlaneEdge {
  geo::PlanePoint from;
  geo::PlanePoint to;
  core::Metres ground_length;
};

/// How exactly to integrate.
struct EdgeAccuracy {
  double relative_tolerance{1e-4};           // of the travel time
  core::Metres longest_step{INFINITY};       // on the ground: the scale on which the current changes in space
  core::Seconds longest_duration{INFINITY};  // and in time
};

/// A vehicle that makes less than this share of its speed through water over the ground is held to stand
/// still.
inline constexpr double least_progress = 0.01;

/// Speed over ground along an edge as a function of the way made and the time.
template <PlaneCurrent Current>
class SpeedAlongEdge {
 public:
  SpeedAlongEdge(const PlaneEdge& edge, core::MetresPerSecond through_water, const Current& current)
      : edge_{edge},
        current_{current},
        dx_{edge.to.x_m - edge.from.x_m},
        dy_{edge.to.y_m - edge.from.y_m},
        v2_{through_water.value * through_water.value},
        v_min_{least_progress * through_water.value} {
    const double plane_length = std::hypot(dx_, dy_);
    ex_ = dx_ / plane_length;
    ey_ = dy_ / plane_length;
  }

  /// Beyond the end of the edge the speed at its end holds, so that trial steps never ask for data that are
  /// not needed.
  tl::expected<double, EdgeClosed> operator()(double way_m, double time_s) const {
    const double share = std::min(way_m / edge_.ground_length.value, 1.0);
    const auto c = current_(geo::PlanePoint{edge_.from.x_m + share * dx_, edge_.from.y_m + share * dy_},
                            core::Seconds{time_s});
    if (!c) return tl::unexpected(EdgeClosed::outside_data);
    const double across = c->x_m_s * ey_ - c->y_m_s * ex_;
    const double margin = v2_ - across * across;
    if (margin <= 0.0) return tl::unexpected(EdgeClosed::current_too_strong);
    const double v = c->x_m_s * ex_ + c->y_m_s * ey_ + std::sqrt(margin);
    if (v <= v_min_) return tl::unexpected(EdgeClosed::current_too_strong);
    return v;
  }

 private:
  const PlaneEdge& edge_;
  const Current& current_;
  double dx_;
  double dy_;
  double ex_{};
  double ey_{};
  double v2_;
  double v_min_;
};

/// A part of the drive along an edge: the way s(t) is the cubic with these values and slopes at its two ends.
/// Units    metres on the ground from the edge's start; seconds on the clock of the departure
struct EdgePiece {
  double t0_s{};
  double way0_m{};
  double v0_m_s{};
  double t1_s{};
  double way1_m{};
  double v1_m_s{};
};

/// Looks at each part of the drive, in the order it is driven, without a gap; an answer closes the edge.
template <class F>
concept EdgePieceVisitor = requires(const F& visit, const EdgePiece& piece) {
  { visit(piece) } -> std::convertible_to<std::optional<EdgeClosed>>;
};

/// Costs nothing.
struct VisitNoPiece {
  std::optional<EdgeClosed> operator()(const EdgePiece&) const { return std::nullopt; }
};

/// Speed, per step, at a share of a step in which the way grows by `gain` from speed v0 to speed v1 (all per
/// step): the slope of the cubic through these values.
inline double speed_in_step(double gain, double v0, double v1, double share) {
  const double a = v0 + v1 - 2.0 * gain;
  const double b = 3.0 * gain - 2.0 * v0 - v1;
  return v0 + share * (2.0 * b + 3.0 * share * a);
}

/// Share of a step after which that cubic reaches `wanted`, by Newton's method. Precondition: the root is
/// near 1 or inside [0, 1].
inline double share_of_step(double gain, double v0, double v1, double wanted) {
  const double a = v0 + v1 - 2.0 * gain;
  const double b = 3.0 * gain - 2.0 * v0 - v1;
  double share = std::min(wanted / gain, 1.5);
  for (int i = 0; i < 8; ++i) {
    const double value = share * (v0 + share * (b + share * a)) - wanted;
    const double next = share - value / speed_in_step(gain, v0, v1, share);
    if (!(std::abs(next - share) > 1e-14)) return next;
    share = next;
  }
  return share;
}

/// Travel time along an edge: the solution of ds/dt = v(x(s), t) from the departure on, where v = c.e +
/// sqrt(V^2 - (c.n)^2) is the speed over ground on the edge's direction e. Two vehicles on one edge obey the
/// same scalar equation, and solutions of a scalar equation do not cross: the later one never overtakes.
/// Hence FIFO: t1 <= t2 implies t1 + w(t1) <= t2 + w(t2), while the edge stays passable.
/// `visit_piece` sees the drive as it is integrated, up to the arrival, and may close the edge.
/// Errors   the reason why the edge is closed: where the vehicle would be, when it would be there; too_late
///          as soon as it is certain that the arrival is after `latest`; what `visit_piece` answered
/// Source   Eichhorn 2009, section III.C (wfunc); integration by Bogacki and Shampine 1989, A 3(2) pair of
///          Runge-Kutta formulas, Appl. Math. Lett. 2, doi:10.1016/0893-9659(89)90079-7, the arrival by its
///          cubic interpolant
template <PlaneCurrent Current, EdgePieceVisitor VisitPiece = VisitNoPiece>
tl::expected<core::Seconds, EdgeClosed> edge_time(const PlaneEdge& edge, core::Seconds depart,
                                                  core::MetresPerSecond through_water, const Current& current,
                                                  const EdgeAccuracy& accuracy,
                                                  core::Seconds latest = core::Seconds{INFINITY},
                                                  const VisitPiece& visit_piece = {}) {
  const double length = edge.ground_length.value;
  if (length <= 0.0) return core::Seconds{0.0};
  const SpeedAlongEdge<Current> speed{edge, through_water, current};

  double way = 0.0;
  double t = depart.count();
  auto k1 = speed(way, t);
  if (!k1) return tl::unexpected(k1.error());

  const double shortest_step = 1e-4 * length / through_water.value;
  double step = INFINITY;
  for (;;) {
    const double to_end = (length - way) / *k1;
    const double h = std::max(shortest_step, std::min({step, to_end, accuracy.longest_step.value / *k1,
                                                       accuracy.longest_duration.count()}));
    const auto k2 = speed(way + 0.5 * h * *k1, t + 0.5 * h);
    const auto k3 = k2 ? speed(way + 0.75 * h * *k2, t + 0.75 * h) : k2;
    const double gain = k3 ? h * (2.0 / 9.0 * *k1 + 1.0 / 3.0 * *k2 + 4.0 / 9.0 * *k3) : 0.0;
    const auto k4 = k3 ? speed(way + gain, t + h) : k3;
    if (!k4) {
      // The trial points lie ahead of the vehicle; only when they close in on it is the edge really closed.
      if (h <= shortest_step) return tl::unexpected(k4.error());
      step = std::max(0.25 * h, shortest_step);
      continue;
    }
    const double error =
        h * std::abs(5.0 / 72.0 * *k1 - 1.0 / 12.0 * *k2 - 1.0 / 9.0 * *k3 + 1.0 / 8.0 * *k4);
    const double allowed = accuracy.relative_tolerance * gain;
    if (error > allowed && h > shortest_step) {
      step = std::max(h * std::clamp(0.9 * std::cbrt(allowed / error), 0.2, 0.9), shortest_step);
      continue;
    }
    // The end is inside this step, or so little beyond it that the interpolant may be trusted there.
    constexpr double trusted_beyond = 1.05;
    if (way + trusted_beyond * gain >= length) {
      const double share = share_of_step(gain, h * *k1, h * *k4, length - way);
      if (share <= trusted_beyond) {
        const double arrival = t + share * h;
        const double v = speed_in_step(gain, h * *k1, h * *k4, share) / h;
        if (const auto closed = visit_piece(EdgePiece{t, way, *k1, arrival, length, v})) {
          return tl::unexpected(*closed);
        }
        return core::Seconds{arrival - depart.count()};
      }
    }
    if (t + h > latest.count()) return tl::unexpected(EdgeClosed::too_late);
    if (const auto closed = visit_piece(EdgePiece{t, way, *k1, t + h, way + gain, *k4})) {
      return tl::unexpected(*closed);
    }
    way += gain;
    t += h;
    k1 = k4;
    // Below a hundredth of what is allowed the step quadruples anyway: no root needed.
    step = h * (100.0 * error > allowed ? std::clamp(0.9 * std::cbrt(allowed / error), 0.5, 4.0) : 4.0);
  }
}

}  // namespace floeplan::motion
