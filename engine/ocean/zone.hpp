#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::ocean {

/// The rule of an area.
enum class ZoneKind {
  no_go,   // keep out
  stay_in  // keep inside this one or another of its kind
};

/// An area with a rule for a vehicle, in force at some depths and for some time.
/// Frame    depths positive down from the surface; both ends of depths and time included
struct Zone {
  std::string name;
  ZoneKind kind{ZoneKind::no_go};
  geo::Polygon area;
  std::optional<core::UtcTime> from;   // empty: from the beginning
  std::optional<core::UtcTime> until;  // empty: without end
  core::Metres top{0.0};
  core::Metres bottom{std::numeric_limits<double>::infinity()};
  std::optional<std::size_t> feature{};  // index in the request; parts of a MultiPolygon share it

  /// Empty when valid, otherwise all of them; fields are "/area", "/until", "/bottom_m".
  [[nodiscard]] core::Violations violations() const;
  [[nodiscard]] bool is_permanent() const { return !from && !until; }
};

/// Whether the zone's rule applies to a vehicle that moves between these depths: a no-go zone if it shares a
/// depth with them; a stay-in zone always.
[[nodiscard]] bool concerns(const Zone& zone, core::Metres shallowest, core::Metres deepest);

/// Whether a stay-in zone contains all these depths of a vehicle.
[[nodiscard]] bool holds_depths(const Zone& zone, core::Metres shallowest, core::Metres deepest);

/// The number of zones, from the first on, that are parts of the same feature; one if the first names no
/// feature.
/// `zones`  at least one, in the order of the request
[[nodiscard]] std::size_t parts_of_first(std::span<const Zone> zones);

/// Name of the kind, "no_go" or "stay_in", and the kind of a name.
[[nodiscard]] std::string zone_kind_name(ZoneKind kind);
[[nodiscard]] std::optional<ZoneKind> parse_zone_kind(const std::string& name);

}  // namespace floeplan::ocean
