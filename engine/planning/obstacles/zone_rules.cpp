#include "engine/planning/obstacles/zone_rules.hpp"

#include <algorithm>
#include <utility>

namespace floeplan::planning::obstacles {

ZoneRules sort_zones(const std::vector<ocean::Zone>& zones, DepthBand band) {
  const bool stay_in_changes = std::ranges::any_of(zones, [](const ocean::Zone& zone) {
    return zone.kind == ocean::ZoneKind::stay_in && !zone.is_permanent();
  });
  ZoneRules rules;
  for (ocean::Zone zone : zones) {
    if (!ocean::concerns(zone, band.shallowest, band.deepest)) continue;
    const bool stays_in = zone.kind == ocean::ZoneKind::stay_in;
    if (stays_in && !ocean::holds_depths(zone, band.shallowest, band.deepest)) zone.area = {};
    if (!zone.is_permanent() || (stays_in && stay_in_changes)) {
      rules.timed.push_back(std::move(zone));
    } else if (stays_in) {
      rules.standing.confined = true;
      rules.standing.stay_in.push_back(std::move(zone.area));
    } else {
      rules.standing.no_go.push_back(std::move(zone.area));
    }
  }
  return rules;
}

}  // namespace floeplan::planning::obstacles
