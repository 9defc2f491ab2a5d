#include "engine/planning/iceberg_rules.hpp"

namespace floeplan::planning {

core::Violations IcebergRules::violations() const {
  core::Violations found;
  const auto require = [&](core::Metres length, const char* field) {
    if (!(length.value >= 0.0 && length.value <= 100'000.0))
      found.push_back({field, "must be between 0 and 100 km"});
  };
  require(margin, "/margin_m");
  require(max_inflation, "/max_inflation_m");
  return found;
}

}  // namespace floeplan::planning
