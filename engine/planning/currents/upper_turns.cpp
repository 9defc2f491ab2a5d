#include "engine/planning/currents/upper_turns.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::currents {

UpperTurns::UpperTurns(const ice::UnderIce& ice, const std::vector<geo::PlanePoint>& places,
                       const std::vector<core::Seconds>& times, const std::stop_token& stop)
    : places_{places.size()} {
  std::vector<std::size_t> near_ice;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (ice.may_be_dense_along(places[i], places[i])) near_ice.push_back(i);
  }
  if (near_ice.empty()) return;
  metres_.assign(times.size() * places.size(), 0);
  ever_below_.assign(places.size(), false);
  for (std::size_t t = 0; t < times.size() && !stop.stop_requested(); ++t) {
    for (const std::size_t i : near_ice) {
      const double turn_m = std::ceil(ice.least_upper_turn(places[i], times[t]).value);
      metres_[t * places_ + i] = static_cast<std::uint16_t>(std::min(turn_m, 65'535.0));
      if (turn_m > 0.0) ever_below_[i] = true;
    }
  }
}

}  // namespace floeplan::planning::currents
