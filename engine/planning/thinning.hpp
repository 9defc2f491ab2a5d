#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/leg_meter.hpp"

namespace floeplan::planning {

/// Takes out free points, each time the one whose loss delays the arrival least, until at most `most` legs
/// are left or none can go without the route closing. The arrival may become later.
template <LegTime Timer>
Itinerary thin_to(LegMeter<Timer>& legs, Itinerary timed, std::size_t most) {
  while (timed.route.legs() > most) {
    const auto& points = timed.route.points;
    std::vector<std::pair<core::Seconds, std::size_t>> losses;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (timed.route.fixed[i]) continue;
      const auto without = legs(points[i - 1], points[i + 1], timed.times[i - 1]);
      if (without) losses.emplace_back(timed.times[i - 1] + *without - timed.times[i + 1], i);
    }
    std::ranges::sort(losses);
    const bool thinned = std::ranges::any_of(losses, [&](const auto& loss) {
      Route shorter = timed.route;
      const auto at = static_cast<std::ptrdiff_t>(loss.second);
      shorter.points.erase(shorter.points.begin() + at);
      shorter.fixed.erase(shorter.fixed.begin() + at);
      auto result = legs.timed(std::move(shorter), timed.times.front());
      if (result) timed = std::move(*result);  // else: arriving later closes a leg further on
      return result.has_value();
    });
    if (!thinned) break;
  }
  return timed;
}

/// A leg cut into equal pieces, timed from `depart`; its start left out. Empty when a piece is closed.
template <LegTime Timer>
std::optional<Itinerary> pieces_of(LegMeter<Timer>& legs, geo::PlanePoint a, geo::PlanePoint b,
                                   bool end_is_fixed, int pieces, core::Seconds depart) {
  Itinerary result;
  geo::PlanePoint from = a;
  for (int k = 1; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    const geo::PlanePoint to =
        k == pieces ? b : geo::PlanePoint{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
    const auto time = legs(from, to, depart);
    if (!time) return std::nullopt;
    depart += *time;
    result.route.points.push_back(to);
    result.route.fixed.push_back(k == pieces && end_is_fixed);
    result.times.push_back(depart);
    from = to;
  }
  return result;
}

/// Into how many pieces each leg goes so that there are `wanted` of them, none lasting long beside the others.
[[nodiscard]] std::vector<int> count_pieces(const Itinerary& timed, std::size_t wanted);

/// Cuts the longest legs until there are `wanted`; the way is the same. A leg that is closed in pieces stays
/// whole.
template <LegTime Timer>
Itinerary split_to(LegMeter<Timer>& legs, const Itinerary& timed, std::size_t wanted) {
  const std::vector<int> pieces = count_pieces(timed, wanted);
  const Route& route = timed.route;
  Itinerary result{{{route.points.front()}, {true}}, {timed.times.front()}};
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    const auto cut = [&](int into) {
      return pieces_of(legs, route.points[i - 1], route.points[i], route.fixed[i], into, result.times.back());
    };
    auto leg = cut(pieces[i - 1]);
    if (!leg) leg = cut(1);
    if (!leg) return timed;  // a departure changed by the integration's error closed the leg
    std::ranges::copy(leg->route.points, std::back_inserter(result.route.points));
    std::ranges::copy(leg->route.fixed, std::back_inserter(result.route.fixed));
    std::ranges::copy(leg->times, std::back_inserter(result.times));
  }
  return result;
}

}  // namespace floeplan::planning
