#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// A straight leg that replaces several legs, between the points of a route with these indices.
struct Shortcut {
  std::size_t from{};
  std::size_t to{};
  double loss{};  // cost added by the replacement
};

/// The chain of shortcuts from the first point to the last with the least sum of losses. It has `most` legs, or fewer
/// if no chain has exactly `most`. Of equal chains the first in `shortcuts` is taken.
/// `shortcuts`  ordered by their ends
/// Returns  the indices of the points, both ends included; empty if no chain is so short
/// Source   Bellman 1961, On the approximation of curves by line segments using dynamic programming, Comm. ACM 4,
///          doi:10.1145/366573.366611
[[nodiscard]] std::optional<std::vector<std::size_t>> least_loss(const std::vector<Shortcut>& shortcuts,
                                                                 std::size_t points, std::size_t most);

/// Straight legs between the points of a route that skip no fixed point and at most `widest` - 1 free points, and are
/// open when the route passes their start.
template <cost::CostedLeg Leg>
std::vector<Shortcut> open_shortcuts(LegMeter<Leg>& legs, const cost::Itinerary& timed, std::size_t widest) {
  const auto& points = timed.route.points;
  std::vector<Shortcut> shortcuts;
  for (std::size_t to = 1; to < points.size(); ++to) {
    for (std::size_t from = to; from-- > 0 && to - from <= widest;) {
      if (from + 1 == to) {
        shortcuts.push_back({from, to, 0.0});
      } else if (const auto leg = legs(points[from], points[to], timed.times[from])) {
        shortcuts.push_back({from, to, timed.costs[from] + leg->cost - timed.costs[to]});
      }
      if (timed.route.fixed[from]) break;
    }
  }
  return shortcuts;
}

/// Removes free points until `most` legs are left: of all choices the one with the least sum of losses. Small losses
/// hardly depend on each other, so this choice is the best. Removal one by one would depend on which point happened
/// to go first.
/// Returns  empty if no choice with so few legs is open
template <cost::CostedLeg Leg>
std::optional<cost::Itinerary> keep_best_points(LegMeter<Leg>& legs, const cost::Itinerary& timed,
                                                std::size_t most) {
  constexpr std::size_t uneven = 8;  // longest leg relative to the mean leg: a judgement
  const std::size_t count = timed.route.points.size();
  if (timed.route.legs() <= most || most == 0) return std::nullopt;
  const std::size_t widest = uneven * ((timed.route.legs() + most - 1) / most);
  const auto kept = least_loss(open_shortcuts(legs, timed, widest), count, most);
  if (!kept) return std::nullopt;
  cost::Route shorter;
  for (const std::size_t i : *kept) {
    shorter.points.push_back(timed.route.points[i]);
    shorter.fixed.push_back(timed.route.fixed[i]);
  }
  return legs.timed(std::move(shorter), timed.times.front());
}

}  // namespace floeplan::planning::refinement
