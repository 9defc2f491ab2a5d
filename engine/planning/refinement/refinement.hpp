#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/refinement/coordinate_descent.hpp"
#include "engine/planning/refinement/gradient_descent.hpp"
#include "engine/planning/refinement/kept_points.hpp"
#include "engine/planning/refinement/leg_meter.hpp"
#include "engine/planning/refinement/leg_trade.hpp"
#include "engine/planning/refinement/longer_legs.hpp"
#include "engine/planning/refinement/thinning.hpp"

namespace floeplan::planning::refinement {

/// Limits on the number of legs of a refined route.
struct RefinementLimits {
  std::size_t finest_legs{128};            // while refining, unless the given route has more
  std::optional<std::size_t> most_legs{};  // of the result; empty: no limit
  double least_gain{5e-4};                 // share of the cost that doubling the legs must gain
  double tolerance{0.0};                   // share of the least cost that may be added for fewer, longer legs
  double least_cost{0.0};                  // known lower bound of the cost of any route

  /// Target accuracy as a share of the cost: at least `share`, and at least `coarse` times the tolerance.
  /// Gains below the tolerance for fewer legs are not worth much work.
  [[nodiscard]] double worth(double share, double coarse) const {
    return std::max(share, coarse * tolerance);
  }
};

/// A route after its points were moved.
struct Refined {
  cost::Itinerary itinerary{};
  RefinementReport report;
};

/// The refinement of one route.
template <cost::CostedLeg Leg>
class Refiner {
 public:
  Refiner(const Leg& leg, const RefinementLimits& limits, const RefinementBudget& budget)
      : leg_{leg}, legs_{leg, budget}, limits_{limits} {}

  Refined operator()(const cost::Itinerary& start, const std::vector<cost::Itinerary>& shorter) {
    found_.offer(start);
    for (const cost::Itinerary& other : shorter) {
      found_.offer(other);
      found_.offer(settle(other));
    }
    constexpr double as_good = 1e-4;  // share of the time: the tolerance of waits
    if (start.cost() > (1.0 + as_good) * limits_.least_cost) move_points(start);
    const cost::Itinerary kept = with_few_long_legs(start);
    return {tidied(kept),
            {.before = start.travel_time(),
             .after = kept.travel_time(),
             .evaluations = legs_.evaluations(),
             .end = legs_.end(),
             .trade = found_.trade()}};
  }

 private:
  void move_points(const cost::Itinerary& start) {
    fewer_and_fewer(more_and_more(start));
    place_better(best_found());
    found_.offer(settle(best_found(), limits_.worth(5e-7, 1e-3)));
  }

  [[nodiscard]] const cost::Itinerary& best_found() const {
    return found_.choose(limits_.least_gain, limits_.most_legs);
  }

  /// The best route found, or one with fewer and longer legs within the tolerance.
  cost::Itinerary with_few_long_legs(const cost::Itinerary& start) {
    const cost::Itinerary& chosen = best_found();
    const bool costs_more = chosen.cost() > start.cost();
    const cost::Itinerary best = costs_more ? found_.choose(0.0, limits_.most_legs) : chosen;
    const double most_cost = (1.0 + limits_.tolerance) * best.cost();
    cost::Itinerary kept = found_.fewest(most_cost).value_or(best);
    while (kept.route.legs() > 1) {
      cost::Itinerary fewer = settle(thinned(kept, kept.route.legs() - 1));
      if (fewer.route.legs() == kept.route.legs() || fewer.cost() > most_cost) break;
      found_.offer(fewer);
      kept = std::move(fewer);
    }
    return without_short_legs(legs_, std::move(kept), most_cost,
                              [this](cost::Itinerary timed) { return settle(std::move(timed)); });
  }

  /// Removes legs too short to steer, where that costs nothing.
  cost::Itinerary tidied(const cost::Itinerary& kept) {
    constexpr core::Metres too_short{0.1};
    constexpr double rounding = 1e-9;   // of sums that differ only by a leg of almost no length
    LegMeter<Leg> unlimited{leg_, {}};  // without a limit, because the budget may be used up
    const auto tidy = unlimited.timed(cost::without_repeats(kept.route, too_short), kept.times.front());
    return tidy && tidy->cost() <= (1.0 + rounding) * kept.cost() ? *tidy : kept;
  }

  /// Moves the points of a route until a round gains less than this share of the cost.
  cost::Itinerary settle(cost::Itinerary timed) {
    return settle(std::move(timed), limits_.worth(5e-6, 0.01));
  }

  cost::Itinerary settle(cost::Itinerary timed, double worth_a_round) {
    constexpr double most_steps_in_a_round = 20.0;
    for (;;) {
      const double before = timed.cost();
      DescentResult found = descend_gradient(legs_, std::move(timed), worth_a_round / most_steps_in_a_round);
      timed = found.met_closed ? CoordinateDescent{legs_, std::move(found.itinerary)}()
                               : std::move(found.itinerary);
      if (before - timed.cost() <= worth_a_round * before) return timed;
    }
  }

  /// Doubles the number of legs and settles the route, until the gain is too small.
  cost::Itinerary more_and_more(const cost::Itinerary& start) {
    constexpr std::size_t at_first = 32;  // with fewer legs the bends of a corridor or a detour get lost
    constexpr double spent_on_more =
        0.2;  // share of the budget: a round costs twice the one before, and thinning needs the rest
    cost::Itinerary best = start;
    std::size_t wanted = std::bit_ceil(std::max(at_first, start.route.legs()));
    for (;;) {
      cost::Itinerary finer = settle(split_to(legs_, best, wanted));
      found_.offer(finer);
      const bool gains = best.cost() - finer.cost() > limits_.worth(limits_.least_gain, 0.2) * best.cost();
      if (finer.cost() < best.cost()) best = std::move(finer);
      wanted *= 2;
      // Points are placed well for this number of legs if they were chosen from twice as many.
      const bool enough = !gains && wanted > 2 * limits_.most_legs.value_or(0);
      if (legs_.spent() > spent_on_more) return best;
      if (enough || wanted > limits_.finest_legs) return best;
    }
  }

  /// Halves the number of legs and settles the route, again and again, until fewer legs would close the
  /// route.
  void fewer_and_fewer(const cost::Itinerary& finest) {
    std::vector<cost::Itinerary> levels{finest};
    while (levels.back().route.legs() > 1) {
      const std::size_t legs = levels.back().route.legs();
      const std::size_t most = limits_.most_legs.value_or(0);
      const std::size_t half = std::bit_ceil(legs) / 2;
      auto settled = settled_with(half < most && most < legs ? most : half, levels);
      if (!settled) return;
      levels.push_back(std::move(*settled));
    }
  }

  /// A route with at most this number of legs. It is the better of two choices of points, which settle in
  /// different places. Empty if no point can be removed.
  std::optional<cost::Itinerary> settled_with(std::size_t fewer, const std::vector<cost::Itinerary>& levels) {
    const cost::Itinerary& last = levels.back();
    cost::Itinerary first = thinned(last, fewer);
    if (first.route.legs() == last.route.legs()) return std::nullopt;
    const auto second = chosen_otherwise(fewer, levels);
    cost::Itinerary best = settle(std::move(first));
    found_.offer(best);
    if (!second) return best;
    cost::Itinerary other = settle(*second);
    found_.offer(other);
    if (other.route.legs() == best.route.legs() && other.cost() < best.cost()) best = std::move(other);
    return best;
  }

  /// A route with this number of legs from the points of the last of `levels` that has many points for each
  /// leg, because thinned points may lack the best ones. If there is only the last level, its points are
  /// removed one by one.
  std::optional<cost::Itinerary> chosen_otherwise(std::size_t fewer,
                                                  const std::vector<cost::Itinerary>& levels) {
    constexpr std::size_t many = 4;
    const auto has_many = [&](const cost::Itinerary& level) { return level.route.legs() >= many * fewer; };
    const auto found = std::find_if(levels.rbegin(), levels.rend(), has_many);
    const cost::Itinerary& from = found == levels.rend() ? levels.front() : *found;
    if (&from != &levels.back()) return keep_best_points(legs_, from, fewer);
    return thin_to(legs_, from, fewer);
  }

  /// A route with this number of legs, or with more if it would close.
  cost::Itinerary thinned(const cost::Itinerary& timed, std::size_t most) {
    auto kept = keep_best_points(legs_, timed, most);
    return kept ? std::move(*kept) : thin_to(legs_, timed, most);
  }

  /// Doubles the legs and reduces them again, so that the points move to better places; repeats while that
  /// gains anything.
  void place_better(cost::Itinerary chosen) {
    const double worth_a_round = limits_.worth(1e-5, 0.02);  // share of the cost
    const std::size_t legs = chosen.route.legs();
    for (;;) {
      cost::Itinerary finer = settle(split_to(legs_, chosen, 2 * legs));
      cost::Itinerary placed = settle(thinned(finer, legs));
      found_.offer(placed);
      const double gain = chosen.cost() - placed.cost();
      if (placed.route.legs() != legs || gain <= worth_a_round * chosen.cost()) return;
      chosen = std::move(placed);
    }
  }

  const Leg& leg_;
  LegMeter<Leg> legs_;
  RefinementLimits limits_;
  LegTradeOff found_;
};

/// Moves the free points of a route until its cost stops falling: first with many legs, then with fewer and
/// fewer, each time from the best route with more legs.
/// `shorter`  routes with at most `most_legs` legs. Without them, a route of many legs thinned to few may
///            settle far from the best
/// Returns  a route with few and long legs that costs at most `tolerance` more than the best one. The best
///          one has the fewest legs for which twice the legs would not gain `least_gain`. It costs no more
///          than the given route, unless `most_legs` forces it, and no more than any of the shorter ones.
///          Fixed points stay, and no leg is closed
/// Stops    when the budget is used up, with the best route found until then
template <cost::CostedLeg Leg>
Refined refine_route(const Leg& leg, const cost::Itinerary& start, const RefinementLimits& limits,
                     const RefinementBudget& budget, const std::vector<cost::Itinerary>& shorter = {}) {
  return Refiner<Leg>{leg, limits, budget}(start, shorter);
}

}  // namespace floeplan::planning::refinement
