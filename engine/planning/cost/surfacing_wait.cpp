#include "engine/planning/cost/surfacing_wait.hpp"

#include <algorithm>

namespace floeplan::planning::cost {

std::optional<core::Seconds> since_surfacing_after_wait(const Sea& sea, geo::PlanePoint place,
                                                        core::Seconds from, core::Seconds until,
                                                        core::Seconds since_surfacing) {
  constexpr core::Seconds between_looks{900.0};
  constexpr core::Seconds just_now{0.0};
  if (!sea.overhead().bounds_surfacing()) return just_now;
  const core::Seconds longest = *sea.overhead().longest_without_surfacing();
  while (from < until) {
    const core::Seconds now = std::min(from + between_looks, until);
    const bool open = sea.overhead().may_surface(place, now);
    const bool open_all_along = open && since_surfacing == just_now;
    if (!open_all_along) since_surfacing += now - from;
    if (since_surfacing > longest) return std::nullopt;
    if (open) since_surfacing = just_now;
    from = now;
  }
  return since_surfacing;
}

}  // namespace floeplan::planning::cost
