#include "engine/ocean/zone.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/messages/fault.hpp"

namespace floeplan::ocean {

core::Violations Zone::violations() const {
  messages::Faults faults;
  const auto is_ring = [](const geo::Ring& ring) {
    return ring.size() >= 3 && std::ranges::all_of(ring, geo::is_valid);
  };
  faults.require<"not-an-area">(is_ring(area.outer) && std::ranges::all_of(area.holes, is_ring), "/area");
  const auto finite = [](const std::optional<core::UtcTime>& time) {
    return !time || std::isfinite(core::unix_seconds(*time));
  };
  faults.require<"not-a-time">(finite(from), "/from");
  faults.require<"not-a-time">(finite(until), "/until");
  faults.require<"ends-before-it-begins">(!from || !until || *from <= *until, "/until");
  faults.require<"not-at-least">(std::isfinite(top.value) && top.value >= 0.0, "/top_m", "0 m");
  faults.require<"bottom-above-top">(bottom.value >= top.value, "/bottom_m");
  return faults.found();
}

bool concerns(const Zone& zone, core::Metres shallowest, core::Metres deepest) {
  return zone.kind == ZoneKind::stay_in || (zone.top <= deepest && zone.bottom >= shallowest);
}

bool holds_depths(const Zone& zone, core::Metres shallowest, core::Metres deepest) {
  return zone.top <= shallowest && zone.bottom >= deepest;
}

std::size_t parts_of_first(std::span<const Zone> zones) {
  const std::optional<std::size_t>& feature = zones.front().feature;
  if (!feature) return 1;
  const auto end = std::ranges::find_if(zones, [&](const Zone& zone) { return zone.feature != feature; });
  return static_cast<std::size_t>(end - zones.begin());
}

std::string zone_kind_name(ZoneKind kind) {
  switch (kind) {
    case ZoneKind::no_go: return "no_go";
    case ZoneKind::stay_in: return "stay_in";
  }
  throw std::logic_error{"ZoneKind without a name"};
}

std::optional<ZoneKind> parse_zone_kind(const std::string& name) {
  for (const ZoneKind kind : {ZoneKind::no_go, ZoneKind::stay_in}) {
    if (name == zone_kind_name(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace floeplan::ocean
