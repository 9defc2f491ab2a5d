#include "engine/avoidance/echo_confirmation.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::avoidance {

bool EchoConfirmation::is_free(const Waiting& waiting) const {
  return waiting.pings == 0 || ping_ - waiting.first_ping >= within_pings;
}

std::optional<Echo> EchoConfirmation::take(const Echo& echo) {
  Waiting* free = nullptr;
  Waiting* oldest = &waiting_.front();
  for (Waiting& waiting : waiting_) {
    if (is_free(waiting)) {
      if (free == nullptr) free = &waiting;
      continue;
    }
    if (waiting.first_ping < oldest->first_ping) oldest = &waiting;
    if (std::abs(waiting.mean.depth_m - echo.depth_m) > gate_m) continue;
    const double dx = waiting.mean.place.x_m - echo.place.x_m;
    const double dy = waiting.mean.place.y_m - echo.place.y_m;
    if (dx * dx + dy * dy > gate_m * gate_m) continue;
    if (waiting.last_ping == ping_) return std::nullopt;  // each ping counts once

    ++waiting.pings;
    waiting.last_ping = ping_;
    const double share = 1.0 / waiting.pings;
    waiting.mean.place.x_m -= share * dx;
    waiting.mean.place.y_m -= share * dy;
    waiting.mean.depth_m += share * (echo.depth_m - waiting.mean.depth_m);
    waiting.mean.range_m = echo.range_m;
    waiting.mean.shallowest_m = std::max(waiting.mean.shallowest_m, echo.shallowest_m);
    waiting.mean.deepest_m = std::min(waiting.mean.deepest_m, echo.deepest_m);
    if (waiting.pings < needed) return std::nullopt;
    const Echo confirmed = waiting.mean;
    waiting = {};
    return confirmed;
  }
  (free != nullptr ? *free : *oldest) = {echo, 1, ping_, ping_};
  return std::nullopt;
}

}  // namespace floeplan::avoidance
