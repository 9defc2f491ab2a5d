#include "engine/planning/optimal_control/way_descent.hpp"

#include <cmath>

namespace floeplan::planning::optimal_control {
namespace {

constexpr int most_iterations = 40;
/// Share of the duration. A smaller gain is within the errors of the leg times.
constexpr double least_gain = 1e-7;
/// Smallest worthwhile gain for a rough start with more legs, where each step costs as much as in the final
/// descent.
constexpr double rough_gain = 1e-4;
/// Step of difference quotients as a share of a leg: small against the bends of a route, large against the errors of
/// times.
constexpr double difference_step = 0.02;
constexpr double least_step = 1e-3;  // smallest share of Newton's step that is tried
// Levenberg's weight in units of the stiffness of a straight leg: smallest value, factor between tries, largest
// value.
constexpr double least_weight = 1e-4;
constexpr double weight_factor = 8.0;
constexpr double most_weight = 1e6;

/// First and second derivatives of the end time of a leg with respect to the offsets a and b of its two ends and its
/// departure t.
struct LegSlopes {
  double a{}, b{}, t{};
  double aa{}, ab{}, bb{}, at{}, bt{}, tt{};
};

/// Quadratic model of the arrival at the goal, as a function of the offset q of a point and the time t there.
struct ArrivalModel {
  double q{}, t{1.0};
  double qq{}, qt{}, tt{};
};

/// The best offset of a point, as a linear function of the offset before it and the time there.
struct Policy {
  double constant{};
  double by_offset{};
  double by_time{};
};

struct Policies {
  std::vector<Policy> of_point;
  double gain{};  // of the full step, predicted by the model
};

geo::PlanePoint unit_across(geo::PlanePoint from, geo::PlanePoint to) {
  const double length = geo::distance_m(from, to);
  if (!(length > 0.0)) return {0.0, 1.0};
  return {-(to.y_m - from.y_m) / length, (to.x_m - from.x_m) / length};
}

/// The route with its directions across and the derivatives of its legs.
class Neighbourhood {
 public:
  Neighbourhood(const TimedWay& way, const LegTimer& leg_timer) : way_{way}, leg_timer_{leg_timer} {
    const auto& points = way.points;
    across_.assign(points.size(), {});
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      across_[i] = unit_across(points[i - 1], points[i + 1]);
    }
  }

  [[nodiscard]] std::size_t legs() const { return way_.points.size() - 1; }
  [[nodiscard]] geo::PlanePoint moved(std::size_t point, double offset) const {
    return {way_.points[point].x_m + offset * across_[point].x_m,
            way_.points[point].y_m + offset * across_[point].y_m};
  }
  [[nodiscard]] double length(std::size_t leg) const {
    return geo::distance_m(way_.points[leg], way_.points[leg + 1]);
  }
  [[nodiscard]] double duration(std::size_t leg) const {
    return (way_.times[leg + 1] - way_.times[leg]).count();
  }

  /// Derivatives of a leg by difference quotients; empty if a neighbouring leg cannot be travelled.
  [[nodiscard]] std::optional<LegSlopes> slopes(std::size_t leg) const {
    const double h = difference_step * length(leg);
    const double s = difference_step * duration(leg);
    const bool may_start_late = leg > 0;  // before the first departure there may be no data
    bool open = true;
    const auto end = [&](int a, int b, int t) {
      const core::Seconds depart = way_.times[leg] + core::Seconds{may_start_late ? s * t : 0.0};
      const auto time = leg_timer_(moved(leg, h * a), moved(leg + 1, h * b), depart);
      open = open && time.has_value();
      return time ? (depart + *time - way_.times[leg]).count() : 0.0;
    };
    const double here = end(0, 0, 0);
    const double a_up = end(1, 0, 0), a_down = end(-1, 0, 0);
    const double b_up = end(0, 1, 0), b_down = end(0, -1, 0);
    const double t_up = end(0, 0, 1), t_down = end(0, 0, -1);
    const auto mixed = [&](double up, double down, double own_1, double own_2) {
      return up + down + 2.0 * here - own_1 - own_2;
    };
    const LegSlopes result{
        .a = (a_up - a_down) / (2.0 * h),
        .b = (b_up - b_down) / (2.0 * h),
        .t = (t_up - t_down) / (2.0 * s),
        .aa = (a_up + a_down - 2.0 * here) / (h * h),
        .ab = mixed(end(1, 1, 0), end(-1, -1, 0), a_up + a_down, b_up + b_down) / (2.0 * h * h),
        .bb = (b_up + b_down - 2.0 * here) / (h * h),
        .at = mixed(end(1, 0, 1), end(-1, 0, -1), a_up + a_down, t_up + t_down) / (2.0 * h * s),
        .bt = mixed(end(0, 1, 1), end(0, -1, -1), b_up + b_down, t_up + t_down) / (2.0 * h * s),
        .tt = (t_up + t_down - 2.0 * here) / (s * s)};
    if (!open) return std::nullopt;
    return result;
  }

  /// The route that follows the policies, with a share of their constant part.
  [[nodiscard]] std::optional<TimedWay> follow(const std::vector<Policy>& policies, double share) const {
    TimedWay next{.points = {way_.points.front()}, .times = {way_.times.front()}};
    double offset = 0.0;
    for (std::size_t i = 1; i < way_.points.size(); ++i) {
      const double late = (next.times.back() - way_.times[i - 1]).count();
      const Policy& policy = policies[i];
      offset = share * policy.constant + policy.by_offset * offset + policy.by_time * late;
      if (!std::isfinite(offset)) return std::nullopt;
      const geo::PlanePoint point = moved(i, offset);
      const auto time = leg_timer_(next.points.back(), point, next.times.back());
      if (!time) return std::nullopt;
      next.points.push_back(point);
      next.times.push_back(next.times.back() + *time);
    }
    return next;
  }

 private:
  const TimedWay& way_;
  const LegTimer& leg_timer_;
  std::vector<geo::PlanePoint> across_;  // zero at the ends, which stay
};

/// The best offset of every point as a function of the state before it, found backwards from the goal. Empty if the
/// model has no minimum with this weight.
std::optional<Policies> best_policies(const Neighbourhood& near, const std::vector<LegSlopes>& slopes,
                                      double weight) {
  Policies result{.of_point = std::vector<Policy>(slopes.size() + 1)};
  ArrivalModel after;  // at the leg's end
  for (std::size_t leg = slopes.size(); leg-- > 0;) {
    const LegSlopes& f = slopes[leg];
    ArrivalModel here{.q = after.t * f.a,
                      .t = after.t * f.t,
                      .qq = after.tt * f.a * f.a + after.t * f.aa,
                      .qt = after.tt * f.a * f.t + after.t * f.at,
                      .tt = after.tt * f.t * f.t + after.t * f.tt};
    if (leg + 1 < slopes.size()) {
      const double stiffness = near.duration(leg) / (near.length(leg) * near.length(leg));
      const double slope = after.q + after.t * f.b;
      const double bend = after.qq + 2.0 * after.qt * f.b + after.tt * f.b * f.b + after.t * f.bb +
                          weight * after.t * stiffness;
      const double with_offset = after.qt * f.a + after.tt * f.a * f.b + after.t * f.ab;
      const double with_time = after.qt * f.t + after.tt * f.b * f.t + after.t * f.bt;
      if (!(bend > 0.0)) return std::nullopt;
      result.of_point[leg + 1] = {-slope / bend, -with_offset / bend, -with_time / bend};
      result.gain += 0.5 * slope * slope / bend;
      here.q -= with_offset * slope / bend;
      here.t -= with_time * slope / bend;
      here.qq -= with_offset * with_offset / bend;
      here.qt -= with_offset * with_time / bend;
      here.tt -= with_time * with_time / bend;
    }
    after = here;
  }
  return result;
}

std::optional<std::vector<LegSlopes>> all_slopes(const Neighbourhood& near) {
  std::vector<LegSlopes> slopes;
  for (std::size_t leg = 0; leg < near.legs(); ++leg) {
    const auto of_leg = near.slopes(leg);
    if (!of_leg) return std::nullopt;
    slopes.push_back(*of_leg);
  }
  return slopes;
}

/// The first faster route between the present one and the one that the policies give.
std::optional<TimedWay> shorter_way(const Neighbourhood& near, const Policies& policies,
                                    core::Seconds duration) {
  for (double share = 1.0; share >= least_step; share *= 0.5) {
    auto next = near.follow(policies.of_point, share);
    if (next && next->duration() < duration) return next;
  }
  return std::nullopt;
}

/// A step to a faster route, and the weight that it needed.
struct Step {
  std::optional<TimedWay> next;  // empty: no faster route was found
  double weight{};
  bool at_minimum{false};  // no step was tried, because the possible gain is too small
  bool closed{false};      // no step was found, because a neighbouring route cannot be travelled
};

/// Raises the weight, which shortens the step, until the route becomes faster.
Step step_down(const TimedWay& way, const LegTimer& leg_timer, double weight, double worthwhile_gain) {
  const Neighbourhood near{way, leg_timer};
  Step step{.next = {}, .weight = weight};
  const auto slopes = all_slopes(near);
  step.closed = !slopes;
  if (!slopes) return step;
  const auto full_step = best_policies(near, *slopes, least_weight);
  step.at_minimum = full_step && full_step->gain <= worthwhile_gain * way.duration().count();
  for (; !step.at_minimum && step.weight <= most_weight; step.weight *= weight_factor) {
    const auto policies = best_policies(near, *slopes, step.weight);
    if (policies) step.next = shorter_way(near, *policies, way.duration());
    if (step.next) break;
  }
  return step;
}

WayDescent descend_until(double worthwhile_gain, const TimedWay& start, const LegTimer& leg_timer,
                         const std::stop_token& stop) {
  WayDescent descent{.way = start};
  double weight = least_weight;
  for (int i = 0; i < most_iterations && !stop.stop_requested(); ++i) {
    Step step = step_down(descent.way, leg_timer, weight, worthwhile_gain);
    if (!step.next) {
      descent.converged = step.at_minimum;
      descent.closed = step.closed;
      return descent;
    }
    descent.way = std::move(*step.next);
    weight = std::max(least_weight, step.weight / weight_factor);
  }
  return descent;
}

}  // namespace

WayDescent descend(const TimedWay& start, const LegTimer& leg_timer, const std::stop_token& stop) {
  return descend_until(least_gain, start, leg_timer, stop);
}

WayDescent descend_roughly(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                           const std::stop_token& stop) {
  const auto even = time_way(cut_evenly(start, legs), start.times.front(), leg_timer);
  if (!even) return {.way = start, .converged = false, .closed = true};
  return descend_until(rough_gain, *even, leg_timer, stop);
}

WayDescent descend_with_legs(const TimedWay& start, std::size_t legs, const LegTimer& leg_timer,
                             const std::stop_token& stop) {
  WayDescent descent{.way = start};
  for (int round = 0; round < 2; ++round) {
    auto even = time_way(cut_evenly(descent.way, legs), start.times.front(), leg_timer);
    if (!even) return {.way = descent.way, .converged = false, .closed = true};
    descent = descend(*even, leg_timer, stop);
  }
  return descent;
}

}  // namespace floeplan::planning::optimal_control
