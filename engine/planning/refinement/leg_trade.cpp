#include "engine/planning/refinement/leg_trade.hpp"

#include <cassert>
#include <cmath>

namespace floeplan::planning::refinement {

void LegTradeOff::offer(const cost::Itinerary& timed) {
  const auto [at, is_new] = cheapest_.try_emplace(timed.route.legs(), timed);
  if (!is_new && timed.cost() < at->second.cost()) at->second = timed;
}

std::vector<LegTrade> LegTradeOff::trade() const {
  std::vector<LegTrade> result;
  double least = INFINITY;
  for (const auto& [legs, timed] : cheapest_) {
    if (!(timed.cost() < least)) continue;
    least = timed.cost();
    result.push_back({legs, timed.travel_time()});
  }
  return result;
}

const cost::Itinerary& LegTradeOff::choose(double least_gain, std::optional<std::size_t> most_legs) const {
  assert(!cheapest_.empty());
  auto chosen = cheapest_.begin();
  for (auto other = std::next(chosen); other != cheapest_.end(); ++other) {
    if (most_legs && other->first > *most_legs) break;
    const double doublings =
        std::log2(static_cast<double>(other->first) / static_cast<double>(chosen->first));
    const double gain = chosen->second.cost() - other->second.cost();
    if (gain > 0.0 && gain >= least_gain * doublings * other->second.cost()) chosen = other;
  }
  return chosen->second;
}

std::optional<cost::Itinerary> LegTradeOff::fewest(double most_cost) const {
  for (const auto& [legs, timed] : cheapest_)
    if (timed.cost() <= most_cost) return timed;
  return std::nullopt;
}

}  // namespace floeplan::planning::refinement
