#include "engine/planning/problem/under_ice_rules.hpp"

#include <string>
#include <utility>

namespace floeplan::planning {

core::Violations UnderIceRules::violations() const {
  core::Violations found;
  const auto require = [&](bool holds, std::string field, std::string rule) {
    if (!holds) found.push_back({"/under_ice/" + std::move(field), std::move(rule)});
  };
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  require(within(max_concentration_to_surface, 0.0, 1.0), "max_concentration_to_surface",
          "must be a share between 0 and 1");
  require(within(margin_below_ice.value, 0.0, 500.0), "margin_below_ice_m", "must be between 0 and 500 m");
  require(within(draft_if_unknown.value, 0.0, 500.0), "draft_if_unknown_m", "must be between 0 and 500 m");
  require(!max_time_without_surfacing || within(max_time_without_surfacing->count(), 60.0, 3.2e7),
          "max_time_without_surfacing_s", "must be between a minute and a year");
  require(!surfacing_interval || within(surfacing_interval->count(), 60.0, 3.2e7), "surfacing_interval_s",
          "must be between a minute and a year");
  require(within(dead_reckoning_share, 0.0, 1.0), "dead_reckoning_share", "must be a share between 0 and 1");
  require(within(current_uncertainty.value, 0.0, 5.0), "current_uncertainty_m_s",
          "must be between 0 and 5 m/s");
  return found;
}

}  // namespace floeplan::planning
