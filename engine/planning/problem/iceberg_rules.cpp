#include "engine/planning/problem/iceberg_rules.hpp"

namespace floeplan::planning {

core::Violations IcebergRules::violations() const {
  core::Violations found;
  const auto require = [&](core::Metres length, const char* field) {
    if (!(length.value >= 0.0 && length.value <= 100'000.0))
      found.push_back({field, "must be between 0 and 100 km"});
  };
  const auto require_between = [&](double value, double most, const char* field, const char* rule) {
    if (!(value >= 0.0 && value <= most)) found.push_back({field, rule});
  };
  require(margin, "/margin_m");
  require(max_inflation, "/max_inflation_m");
  require_between(encounter_weight.count(), 1e7, "/encounter_weight_s", "must be between 0 and 10000000 s");
  require_between(keel_clearance.value, 1000.0, "/keel_clearance_m", "must be between 0 and 1000 m");
  require_between(draft_uncertainty, 2.0, "/draft_uncertainty", "must be between 0 and 2");
  return found;
}

}  // namespace floeplan::planning
