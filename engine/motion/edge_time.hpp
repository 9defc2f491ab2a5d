#pragma once

#include <algorithm>
#include <cmath>
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
  double relative_tolerance{1e-4};      // of the travel time
  core::Metres longest_step{INFINITY};  // on the ground: the scale on which the current changes
};

/// A vehicle that makes less than this share of its speed through water over the ground is held to stand
/// still.
inline constexpr double least_progress = 0.01;

/// Travel time along an edge: the solution of dt/ds = 1 / v(x(s), t) from the departure on, where
/// v = c.e + sqrt(V^2 - (c.n)^2) is the speed over ground on the edge's direction e.
/// Two vehicles on one edge obey the same scalar equation, and solutions of a scalar equation do not cross:
/// the later one never overtakes. Hence FIFO: t1 <= t2 implies t1 + w(t1) <= t2 + w(t2), while the edge stays
/// passable. Errors   the reason why the edge is closed: where the vehicle would be, when it would be there
/// Source   planning: Eichhorn 2009, section III.C; integration: Bogacki and Shampine 1989, A 3(2) pair of
/// Runge-Kutta
///          formulas, Appl. Math. Lett. 2, doi:10.1016/0893-9659(89)90079-7
template <PlaneCurrent Current>
tl::expected<core::Seconds, EdgeClosed> edge_time(const PlaneEdge& edge, core::Seconds depart,
                                                  core::MetresPerSecond through_water, const Current& current,
                                                  const EdgeAccuracy& accuracy) {
  const double length = edge.ground_length.value;
  if (length <= 0.0) return core::Seconds{0.0};
  const double dx = edge.to.x_m - edge.from.x_m;
  const double dy = edge.to.y_m - edge.from.y_m;
  const double plane_length = std::hypot(dx, dy);
  const double ex = dx / plane_length;
  const double ey = dy / plane_length;
  const double v2 = through_water.value * through_water.value;
  const double v_min = least_progress * through_water.value;

  // Seconds for each metre on the ground, at distance s along the edge and time t.
  const auto slowness = [&](double s, double t) -> tl::expected<double, EdgeClosed> {
    const double share = s / length;
    const auto c =
        current(geo::PlanePoint{edge.from.x_m + share * dx, edge.from.y_m + share * dy}, core::Seconds{t});
    if (!c) return tl::unexpected(EdgeClosed::outside_data);
    const double across = c->x_m_s * ey - c->y_m_s * ex;
    const double margin = v2 - across * across;
    if (margin <= 0.0) return tl::unexpected(EdgeClosed::current_too_strong);
    const double v = c->x_m_s * ex + c->y_m_s * ey + std::sqrt(margin);
    if (v <= v_min) return tl::unexpected(EdgeClosed::current_too_strong);
    return 1.0 / v;
  };

  double s = 0.0;
  double t = depart.count();
  const double shortest_step = 1e-4 * length;
  const double longest_step = std::clamp(accuracy.longest_step.value, shortest_step, length);
  double step = longest_step;
  auto k1 = slowness(s, t);
  if (!k1) return tl::unexpected(k1.error());
  while (s < length) {
    const double h = std::min(step, length - s);
    const auto k2 = slowness(s + 0.5 * h, t + 0.5 * h * *k1);
    const auto k3 = k2 ? slowness(s + 0.75 * h, t + 0.75 * h * *k2) : k2;
    const double advance = k3 ? h * (2.0 / 9.0 * *k1 + 1.0 / 3.0 * *k2 + 4.0 / 9.0 * *k3) : 0.0;
    const auto k4 = k3 ? slowness(s + h, t + advance) : k3;
    if (!k4) {
      // The trial points lie ahead at guessed times; only when they close in on the vehicle is the edge
      // really closed.
      if (h <= shortest_step) return tl::unexpected(k4.error());
      step = std::max(0.25 * h, shortest_step);
      continue;
    }
    const double error =
        h * std::abs(5.0 / 72.0 * *k1 - 1.0 / 12.0 * *k2 - 1.0 / 9.0 * *k3 + 1.0 / 8.0 * *k4);
    const double allowed = accuracy.relative_tolerance * advance;
    if (error > allowed && h > shortest_step) {
      step = std::max(h * std::clamp(0.9 * std::cbrt(allowed / error), 0.2, 0.9), shortest_step);
      continue;
    }
    s = h < length - s ? s + h : length;
    t += advance;
    k1 = k4;
    const double growth = error > 0.0 ? 0.9 * std::cbrt(allowed / error) : 4.0;
    step = std::clamp(h * std::clamp(growth, 0.5, 4.0), shortest_step, longest_step);
  }
  return core::Seconds{t - depart.count()};
}

}  // namespace floeplan::motion
