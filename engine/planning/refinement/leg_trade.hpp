#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning::refinement {

/// The cheapest routes from one start to one goal for each number of legs.
class LegTradeOff {
 public:
  void offer(const cost::Itinerary& timed);

  /// Ordered by number of legs; only routes that cost less than all with fewer legs.
  [[nodiscard]] std::vector<LegTrade> trade() const;

  /// The route with the fewest legs for which twice as many legs would lower the cost by less than the share
  /// `least_gain`. With `most_legs`, a route with at most this number of legs, if there is one.
  /// Precondition  a route was offered
  [[nodiscard]] const cost::Itinerary& choose(double least_gain, std::optional<std::size_t> most_legs) const;

  /// The route with the fewest legs that costs at most `most_cost`; empty if there is none.
  [[nodiscard]] std::optional<cost::Itinerary> fewest(double most_cost) const;

 private:
  std::map<std::size_t, cost::Itinerary> cheapest_;
};

}  // namespace floeplan::planning::refinement
