#include "engine/planning/problem/iceberg_rules.hpp"

#include "engine/messages/fault.hpp"

namespace floeplan::planning {

core::Violations IcebergRules::violations() const {
  messages::Faults faults;
  faults.within(margin.value, 0.0, 100'000.0, "/margin_m", "0", "100 km");
  faults.within(max_inflation.value, 0.0, 100'000.0, "/max_inflation_m", "0", "100 km");
  faults.within(encounter_weight.count(), 0.0, 1e7, "/encounter_weight_s", "0", "10000000 s");
  faults.within(keel_clearance.value, 0.0, 1000.0, "/keel_clearance_m", "0", "1000 m");
  faults.within(draft_uncertainty, 0.0, 2.0, "/draft_uncertainty", "0", "2");
  return faults.found();
}

}  // namespace floeplan::planning
