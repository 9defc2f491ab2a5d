#include "engine/planning/obstacles/expected_encounters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace floeplan::planning::obstacles {
namespace {

/// Ratio of the mean distance from the centre to the standard deviation, for a two-dimensional normal
/// distribution.
const double mean_per_deviation = std::sqrt(0.5 * std::numbers::pi);

struct Interval {
  double from_s;
  double until_s;
};

/// The berg's position has a two-dimensional normal density; its mean error is sqrt(pi / 2) standard
/// deviations. The vehicle, at its speed relative to the berg, sweeps a strip of the width 2 * `kept_m`
/// through this density. Integrated by Simpson's rule in steps of at most half a standard deviation of
/// travel, or ten minutes.
double encounters_with(const motion::MovingDisc& disc, const motion::EvenMove& move, Interval during,
                       double kept_m, const PositionError& error) {
  constexpr double farthest = 6.0;  // standard deviations: the density is 1e-8 of that at the centre
  constexpr double longest_step_s = 600.0;
  constexpr double shortest_step_s = 10.0;
  const double duration_s = move.t1_s - move.t0_s;
  const double vx = (move.to.x_m - move.from.x_m) / duration_s - disc.velocity.x_m_s;
  const double vy = (move.to.y_m - move.from.y_m) / duration_s - disc.velocity.y_m_s;
  const double speed_m_s = std::hypot(vx, vy);
  const double widest_m =
      std::max(error.mean_m(during.from_s), error.mean_m(during.until_s)) / mean_per_deviation;
  const double nearest_m =
      motion::least_distance(move, disc).value_or(std::numeric_limits<double>::infinity());
  if (speed_m_s <= 0.0 || widest_m <= 0.0 || nearest_m > farthest * widest_m) return 0.0;

  const auto rate = [&](double t_s) {
    const double deviation_m = std::max(error.mean_m(t_s) / mean_per_deviation, 1.0);
    const geo::PlanePoint vehicle = motion::place_at(move, t_s);
    const double dx = vehicle.x_m - disc.centre0.x_m - (t_s - disc.t0_s) * disc.velocity.x_m_s;
    const double dy = vehicle.y_m - disc.centre0.y_m - (t_s - disc.t0_s) * disc.velocity.y_m_s;
    const double square = (dx * dx + dy * dy) / (deviation_m * deviation_m);
    const double density = std::exp(-0.5 * square) / (2.0 * std::numbers::pi * deviation_m * deviation_m);
    return 2.0 * kept_m * speed_m_s * density;
  };
  const double narrowest_m =
      std::min(error.mean_m(during.from_s), error.mean_m(during.until_s)) / mean_per_deviation;
  const double step_s = std::clamp(0.5 * narrowest_m / speed_m_s, shortest_step_s, longest_step_s);
  const int steps = static_cast<int>(std::ceil((during.until_s - during.from_s) / step_s));
  const double h = (during.until_s - during.from_s) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double a = during.from_s + i * h;
    sum += h / 6.0 * (rate(a) + 4.0 * rate(a + 0.5 * h) + rate(a + h));
  }
  return sum;
}

}  // namespace

double expected_encounters(const DriftingDisc& iceberg, const PositionError& error, bool passed_under,
                           const motion::EvenMove& move) {
  double sum = 0.0;
  iceberg.for_each_piece(move.t0_s, move.t1_s, [&](const motion::MovingDisc& disc) {
    const double from_s = std::max(move.t0_s, disc.t0_s);
    const double until_s = std::min(move.t1_s, disc.t1_s);
    const auto add = [&](double begin_s, double end_s) {
      if (begin_s < end_s) sum += encounters_with(disc, move, {begin_s, end_s}, iceberg.kept_m(), error);
    };
    const auto under = passed_under ? time_within(disc, move) : std::nullopt;
    add(from_s, under ? under->from.count() : until_s);
    if (under) add(under->until.count(), until_s);
    return false;
  });
  return sum;
}

double encounter_rate(const DriftingDisc& iceberg, const PositionError& error, bool passed_under,
                      geo::PlanePoint point, core::Seconds time, core::MetresPerSecond speed,
                      core::Metres blur) {
  constexpr double farthest_square = 36.0;  // square of six standard deviations
  const double error_m = error.mean_m(time.count());
  if (error_m <= 0.0) return 0.0;
  const double deviation_m = std::max(error_m / mean_per_deviation, blur.value);
  double rate = 0.0;
  iceberg.for_each_piece(time.count(), time.count(), [&](const motion::MovingDisc& disc) {
    const double since_s = time.count() - disc.t0_s;
    const double dx = point.x_m - disc.centre0.x_m - since_s * disc.velocity.x_m_s;
    const double dy = point.y_m - disc.centre0.y_m - since_s * disc.velocity.y_m_s;
    const double square = (dx * dx + dy * dy) / (deviation_m * deviation_m);
    const bool under = passed_under && std::hypot(dx, dy) <= disc.radius0_m + since_s * disc.growth_m_s;
    if (square < farthest_square && !under) {
      rate = 2.0 * iceberg.kept_m() * speed.value * std::exp(-0.5 * square) /
             (2.0 * std::numbers::pi * deviation_m * deviation_m);
    }
    return true;
  });
  return rate;
}

}  // namespace floeplan::planning::obstacles
