#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/planning/hat_moves.hpp"
#include "engine/planning/leg_meter.hpp"
#include "engine/planning/leg_trade.hpp"
#include "engine/planning/smooth_moves.hpp"
#include "engine/planning/thinning.hpp"

namespace floeplan::planning {

/// How many legs a refined route may have.
struct RefinementLimits {
  std::size_t finest_legs{128};            // to work with, unless the route comes with more
  std::optional<std::size_t> most_legs{};  // of the result; empty: as many as serve
  double least_gain{5e-4};                 // share of the cost for which twice as many legs are taken
};

/// A route after its points were moved.
struct Refined {
  Itinerary itinerary{};
  RefinementReport report;
};

/// The refinement of one route.
template <CostedLeg Leg>
class Refiner {
 public:
  Refiner(const Leg& leg, const RefinementLimits& limits, const RefinementBudget& budget)
      : leg_{leg}, legs_{leg, budget}, limits_{limits} {}

  Refined operator()(const Itinerary& start, const std::vector<Itinerary>& shorter) {
    found_.offer(start);
    for (const Itinerary& other : shorter) {
      found_.offer(other);
      found_.offer(settle(other));
    }
    fewer_and_fewer(more_and_more(start));
    place_better(found_.choose(limits_.least_gain, limits_.most_legs));
    const Itinerary& chosen = found_.choose(limits_.least_gain, limits_.most_legs);
    const bool costs_more = chosen.cost() > start.cost();
    const Itinerary& kept = costs_more ? found_.choose(0.0, limits_.most_legs) : chosen;
    return {tidied(kept),
            {.before = start.travel_time(),
             .after = kept.travel_time(),
             .evaluations = legs_.evaluations(),
             .end = legs_.end(),
             .trade = found_.trade()}};
  }

 private:
  /// Without legs too short to steer, where that costs nothing.
  Itinerary tidied(const Itinerary& kept) {
    constexpr core::Metres too_short{0.1};
    constexpr double rounding = 1e-9;   // of sums that differ by a leg of almost no length
    LegMeter<Leg> unlimited{leg_, {}};  // the budget may have ended
    const auto tidy = unlimited.timed(without_repeats(kept.route, too_short), kept.times.front());
    return tidy && tidy->cost() <= (1.0 + rounding) * kept.cost() ? *tidy : kept;
  }

  /// Moves the points of a route until that gains nothing more.
  Itinerary settle(Itinerary timed) {
    constexpr double worth_a_step = 2.5e-7;  // shares of the cost
    constexpr double worth_a_round = 5e-6;
    for (;;) {
      const double before = timed.cost();
      SmoothMoves moves = descend_smoothly(legs_, std::move(timed), worth_a_step);
      timed = moves.met_closed ? HatMoves{legs_, std::move(moves.itinerary)}() : std::move(moves.itinerary);
      if (before - timed.cost() <= worth_a_round * before) return timed;
    }
  }

  /// Doubles the legs and settles until that gains too little.
  Itinerary more_and_more(const Itinerary& start) {
    constexpr std::size_t at_first = 32;   // fewer lose the corridor's bends, or its way round an obstacle
    constexpr double spent_on_more = 0.2;  // a round costs twice the last one, and thinning must be paid
    Itinerary best = start;
    std::size_t wanted = std::bit_ceil(std::max(at_first, start.route.legs()));
    for (;;) {
      Itinerary finer = settle(split_to(legs_, best, wanted));
      found_.offer(finer);
      const bool gains = best.cost() - finer.cost() > limits_.least_gain * best.cost();
      if (finer.cost() < best.cost()) best = std::move(finer);
      wanted *= 2;
      // Points are well placed for so many legs when they were chosen from twice as many.
      const bool enough = !gains && wanted > 2 * limits_.most_legs.value_or(0);
      if (legs_.spent() > spent_on_more) return best;
      if (enough || wanted > limits_.finest_legs) return best;
    }
  }

  /// Halves the legs and settles until the route would close.
  void fewer_and_fewer(Itinerary timed) {
    while (timed.route.legs() > 1) {
      const std::size_t legs = timed.route.legs();
      const std::size_t most = limits_.most_legs.value_or(0);
      const std::size_t half = std::bit_ceil(legs) / 2;
      Itinerary thinned = thin_to(legs_, std::move(timed), half < most && most < legs ? most : half);
      if (thinned.route.legs() == legs) return;
      timed = settle(std::move(thinned));
      found_.offer(timed);
    }
  }

  /// Twice the legs and back to as many as before, so that the points end up where they serve best: again and again
  /// until that gains nothing more.
  void place_better(Itinerary chosen) {
    constexpr double worth_a_round = 1e-5;  // share of the cost
    const std::size_t legs = chosen.route.legs();
    for (;;) {
      Itinerary finer = settle(split_to(legs_, chosen, 2 * legs));
      Itinerary placed = settle(thin_to(legs_, std::move(finer), legs));
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

/// Moves the free points of a route until its cost stops falling: first with many legs, then with
/// fewer and fewer, each time from the best way with more of them.
/// `shorter`  routes with no more legs than `most_legs`: without them the points of many legs, thinned to few, may
///            settle far from the best
/// Returns  the route with the fewest legs of which twice as many would not gain `least_gain`; fixed points
///          stay, no leg is closed, and it costs no more than the route that came unless `most_legs` forces it, and no
///          more than any of the shorter ones
/// Stops    when the budget ends, with the best found until then
template <CostedLeg Leg>
Refined refine_route(const Leg& leg, const Itinerary& start, const RefinementLimits& limits,
                     const RefinementBudget& budget, const std::vector<Itinerary>& shorter = {}) {
  return Refiner<Leg>{leg, limits, budget}(start, shorter);
}

}  // namespace floeplan::planning
