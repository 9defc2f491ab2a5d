#include "engine/planning/problem/uncertainty_rules.hpp"

#include <cmath>

#include "engine/messages/fault.hpp"

namespace floeplan::planning {

core::Violations UncertaintyRules::violations() const {
  messages::Faults faults;
  // A member costs a planning area's currents in memory while it is at work, and a search when optimised.
  faults.require<"not-between">(drawn_members == 0 || (drawn_members >= 2 && drawn_members <= 64), "/members",
                                "2", "64");
  if (drawn_members > 0) faults.take(error.violations());
  faults.require<"not-between">(quantile > 0.0 && quantile < 1.0, "/quantile", "0", "1, both excluded");
  faults.require<"not-a-time">(!arrive_before || std::isfinite(core::unix_seconds(*arrive_before)),
                               "/arrive_before");
  return faults.found();
}

}  // namespace floeplan::planning
