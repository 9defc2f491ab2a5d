#include "engine/planning/problem/under_ice_rules.hpp"

#include "engine/messages/fault.hpp"

namespace floeplan::planning {

core::Violations UnderIceRules::violations() const {
  messages::Faults faults{"/under_ice/"};
  faults.within(max_concentration_to_surface, 0.0, 1.0, "max_concentration_to_surface", "0", "1");
  faults.within(margin_below_ice.value, 0.0, 500.0, "margin_below_ice_m", "0", "500 m");
  faults.within(draft_if_unknown.value, 0.0, 500.0, "draft_if_unknown_m", "0", "500 m");
  if (max_time_without_surfacing)
    faults.within(max_time_without_surfacing->count(), 60.0, 3.2e7, "max_time_without_surfacing_s", "a minute",
           "a year");
  if (surfacing_interval)
    faults.within(surfacing_interval->count(), 60.0, 3.2e7, "surfacing_interval_s", "a minute", "a year");
  faults.within(dead_reckoning_share, 0.0, 1.0, "dead_reckoning_share", "0", "1");
  faults.within(current_uncertainty.value, 0.0, 5.0, "current_uncertainty_m_s", "0", "5 m/s");
  return faults.found();
}

}  // namespace floeplan::planning
