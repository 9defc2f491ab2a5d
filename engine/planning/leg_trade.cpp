#include "engine/planning/leg_trade.hpp"

#include <cassert>
#include <cmath>

namespace floeplan::planning {

void LegTradeOff::offer(const Itinerary& timed) {
  const auto [at, is_new] = fastest_.try_emplace(timed.route.legs(), timed);
  if (!is_new && timed.arrival() < at->second.arrival()) at->second = timed;
}

std::vector<LegTrade> LegTradeOff::trade() const {
  std::vector<LegTrade> result;
  for (const auto& [legs, timed] : fastest_) {
    if (result.empty() || timed.travel_time() < result.back().travel_time) {
      result.push_back({legs, timed.travel_time()});
    }
  }
  return result;
}

const Itinerary& LegTradeOff::choose(double least_gain, std::optional<std::size_t> most_legs) const {
  assert(!fastest_.empty());
  auto chosen = fastest_.begin();
  for (auto other = std::next(chosen); other != fastest_.end(); ++other) {
    if (most_legs && other->first > *most_legs) break;
    const double doublings =
        std::log2(static_cast<double>(other->first) / static_cast<double>(chosen->first));
    const core::Seconds gain = chosen->second.travel_time() - other->second.travel_time();
    if (gain.count() > 0.0 && gain >= least_gain * doublings * other->second.travel_time()) chosen = other;
  }
  return chosen->second;
}

}  // namespace floeplan::planning
