#include "engine/planning/optimal_control/free_way.hpp"

#include <array>
#include <cmath>

#include "engine/planning/optimal_control/way_descent.hpp"
#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::optimal_control {
namespace {

constexpr double settled = 1e-3;

/// Extrapolated duration for ever more legs. `fine` has twice the legs of `coarse`, and a quarter of its
/// error.
core::Seconds limit(core::Seconds coarse, core::Seconds fine) { return fine - (coarse - fine) / 3.0; }

constexpr std::size_t coarsest = 64;
constexpr std::size_t rough_legs = coarsest / 4;

tl::expected<TimedWay, NoFreeWay> with_legs(const TimedWay& start, std::size_t legs,
                                            const LegTimer& leg_timer, const std::stop_token& stop) {
  WayDescent descent = descend_with_legs(start, legs, leg_timer, stop);
  if (stop.stop_requested()) return tl::unexpected(NoFreeWay::cancelled);
  if (descent.closed) return tl::unexpected(NoFreeWay::closed);
  if (!descent.converged) return tl::unexpected(NoFreeWay::not_settled);
  return std::move(descent.way);
}

}  // namespace

TimedWay find_rough_free_way(const TimedWay& start, const LegTimer& leg_timer, const std::stop_token& stop) {
  WayDescent rough = descend_roughly(start, rough_legs, leg_timer, stop);
  if (rough.closed) return start;
  return std::move(rough.way);
}

bool lead_to_one_way(const TimedWay& a, const TimedWay& b) {
  if (a.points.size() != rough_legs + 1 || b.points.size() != rough_legs + 1) return false;
  // Only the distance across the route is compared: where the points lie along the route depends on the start
  // of the descent.
  const auto is_near_b = [&](geo::PlanePoint point, double near_m) {
    for (std::size_t i = 1; i < b.points.size(); ++i)
      if (plane::distance_to_line(point, b.points[i - 1], b.points[i]) <= near_m) return true;
    return false;
  };
  for (std::size_t i = 1; i < rough_legs; ++i)
    if (!is_near_b(a.points[i], 0.25 * geo::distance_m(a.points[i - 1], a.points[i]))) return false;
  return true;
}

tl::expected<TimedWay, NoFreeWay> find_coarse_free_way(const TimedWay& rough, const LegTimer& leg_timer,
                                                       const std::stop_token& stop) {
  return with_legs(rough, coarsest, leg_timer, stop);
}

tl::expected<FreeWay, NoFreeWay> find_free_way(const TimedWay& start, const LegTimer& leg_timer,
                                               const std::stop_token& stop) {
  TimedWay way = start;
  std::array<core::Seconds, 3> durations{};
  for (std::size_t level = 0; level < durations.size(); ++level) {
    auto finer = with_legs(way, coarsest << level, leg_timer, stop);
    if (!finer) return tl::unexpected(finer.error());
    way = std::move(*finer);
    durations[level] = way.duration();
  }
  const core::Seconds before = limit(durations[0], durations[1]);
  const core::Seconds last = limit(durations[1], durations[2]);
  const double accuracy = std::abs((last - before) / last);
  if (!(accuracy < settled)) return tl::unexpected(NoFreeWay::not_settled);
  return FreeWay{.way = std::move(way), .duration = last, .accuracy = accuracy};
}

}  // namespace floeplan::planning::optimal_control
