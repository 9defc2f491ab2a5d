#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning::refinement {

/// Routes from one start to one goal, the one that costs least of each number of legs: what a leg more is worth.
class LegTradeOff {
 public:
  void offer(const cost::Itinerary& timed);

  /// Few legs first; only routes that cost less than every one with fewer legs.
  [[nodiscard]] std::vector<LegTrade> trade() const;

  /// The route with the fewest legs of which twice as many would not gain the share `least_gain` of the cost. With
  /// `most_legs` none with more than those, unless there is no other.
  /// Precondition: a route was offered
  [[nodiscard]] const cost::Itinerary& choose(double least_gain, std::optional<std::size_t> most_legs) const;

  /// The route with the fewest legs that costs at most so much; empty where none does.
  [[nodiscard]] std::optional<cost::Itinerary> fewest(double most_cost) const;

 private:
  std::map<std::size_t, cost::Itinerary> cheapest_;
};

}  // namespace floeplan::planning::refinement
