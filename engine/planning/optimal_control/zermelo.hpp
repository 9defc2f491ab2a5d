#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/sloped_current.hpp"
#include "engine/planning/optimal_control/timed_way.hpp"

namespace floeplan::planning::optimal_control {

/// The crossing to optimise: from one place to another at a constant speed through the water, with any
/// heading, without obstacles.
struct Crossing {
  geo::PlanePoint from;
  geo::PlanePoint to;
  core::Seconds depart{};
  core::MetresPerSecond through_water;
};

/// The place and the heading of the vehicle. The heading is in radians, counter-clockwise from the plane's x axis, and is
/// not wrapped.
struct SteeredPoint {
  double x_m{};
  double y_m{};
  double heading{};
};

/// A route for which, to first order, no small change of the headings shortens the duration.
struct Extremal {
  core::Seconds duration{};
  std::vector<SteeredPoint> points;  // at equal steps of time, start and goal included
};

/// Why no extremal was found.
enum class NoExtremal {
  outside_data,   // the first guess leads to where the current is unknown
  not_converged,  // the equations were not solved to the tolerance
  cancelled
};

/// Follows an extremal for `duration`; empty where the current is not known.
using ExtremalFlow = std::function<std::optional<SteeredPoint>(const SteeredPoint& at, core::Seconds time,
                                                               core::Seconds duration)>;

/// Integrates the equations of motion and Zermelo's navigation formula with the classical Runge-Kutta method.
/// Accuracy fourth order in `longest_step`
/// Source   Eichhorn 2009, equations (5) and (6); Zermelo 1931, doi:10.1002/zamm.19310110205
template <motion::SlopedPlaneCurrent Current>
class ZermeloFlow {
 public:
  ZermeloFlow(const Current& current, core::MetresPerSecond through_water, core::Seconds longest_step)
      : current_{current}, speed_{through_water.value}, longest_step_{longest_step} {}

  std::optional<SteeredPoint> operator()(const SteeredPoint& at, core::Seconds time,
                                         core::Seconds duration) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(duration / longest_step_)));
    const double h = duration.count() / steps;
    SteeredPoint point = at;
    for (int i = 0; i < steps; ++i) {
      const double t = time.count() + i * h;
      const auto k1 = rate(point, t);
      const auto k2 = k1 ? rate(moved(point, *k1, 0.5 * h), t + 0.5 * h) : k1;
      const auto k3 = k2 ? rate(moved(point, *k2, 0.5 * h), t + 0.5 * h) : k2;
      const auto k4 = k3 ? rate(moved(point, *k3, h), t + h) : k3;
      if (!k4) return std::nullopt;
      point = moved(moved(moved(moved(point, *k1, h / 6.0), *k2, h / 3.0), *k3, h / 3.0), *k4, h / 6.0);
    }
    return point;
  }

 private:
  [[nodiscard]] std::optional<SteeredPoint> rate(const SteeredPoint& at, double time_s) const {
    const auto c = current_.slopes_at(geo::PlanePoint{at.x_m, at.y_m}, core::Seconds{time_s});
    if (!c) return std::nullopt;
    const double cosine = std::cos(at.heading);
    const double sine = std::sin(at.heading);
    return SteeredPoint{
        c->velocity.x_m_s + speed_ * cosine, c->velocity.y_m_s + speed_ * sine,
        -c->dx_dy * cosine * cosine + (c->dx_dx - c->dy_dy) * cosine * sine + c->dy_dx * sine * sine};
  }
  static SteeredPoint moved(const SteeredPoint& at, const SteeredPoint& rate, double by) {
    return {at.x_m + by * rate.x_m, at.y_m + by * rate.y_m, at.heading + by * rate.heading};
  }

  const Current& current_;
  double speed_;
  core::Seconds longest_step_;
};

/// A first guess for an extremal: a route divided into equal time steps, with the headings that keep the
/// vehicle on it in the current.
struct ExtremalGuess {
  core::Seconds duration{};
  std::vector<SteeredPoint> points;
};

/// The guess for a route divided into `pieces`; empty if the current is unknown somewhere.
/// Precondition  two points or more, two pieces or more
[[nodiscard]] std::optional<ExtremalGuess> guess_along(
    const TimedWay& route,
    const std::function<std::optional<motion::CurrentXy>(geo::PlanePoint, core::Seconds)>& current,
    std::size_t pieces);

/// Solves for the extremal near the guess by multiple shooting. The unknowns are the points between the pieces, the headings
/// and the duration. The equations demand that the pieces join and that the last one ends at the goal. Newton's method is
/// damped so that each step comes nearer to the solution. Single shooting fails where the current drives neighbouring routes
/// apart exponentially.
/// Accuracy the equations are solved to 1e-11 of the distance and of the duration; the flow's error adds to that
/// Returns  an extremal. It is only a candidate for the fastest route: other extremals may be faster
/// Source   Stoer and Bulirsch 2002, Introduction to Numerical Analysis, section 7.3.5 (multiple shooting);
///          Deuflhard 2004, Newton Methods for Nonlinear Problems, section 3.3 (natural monotonicity)
/// Stops    with NoExtremal::cancelled once `stop` is requested
[[nodiscard]] tl::expected<Extremal, NoExtremal> solve_extremal(const Crossing& crossing,
                                                                const ExtremalFlow& flow,
                                                                const ExtremalGuess& guess,
                                                                const std::stop_token& stop = {});

}  // namespace floeplan::planning::optimal_control
