#include "engine/planning/problem/uncertainty_rules.hpp"

#include <cmath>
#include <utility>

namespace floeplan::planning {

core::Violations UncertaintyRules::violations() const {
  core::Violations found;
  const auto require = [&](bool holds, const char* field, const char* rule) {
    if (!holds) found.push_back({field, rule});
  };
  // A member costs a planning area's currents in memory while it is at work, and a search when optimised.
  require(drawn_members == 0 || (drawn_members >= 2 && drawn_members <= 64), "/members",
          "must be from 2 to 64");
  if (drawn_members > 0) {
    for (core::Violation& violation : error.violations()) found.push_back(std::move(violation));
  }
  require(quantile > 0.0 && quantile < 1.0, "/quantile", "must be between 0 and 1, both excluded");
  require(!arrive_before || std::isfinite(core::unix_seconds(*arrive_before)), "/arrive_before",
          "must be a time");
  return found;
}

}  // namespace floeplan::planning
