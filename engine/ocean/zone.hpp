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

/// What an area asks of a vehicle.
enum class ZoneKind {
  no_go,   // keep out
  stay_in  // keep inside this one or another of its kind
};

/// An area with a rule, in force for some depths and some time.
/// Frame    depths positive down from the surface; both ends of depths and time included
struct Zone {
  std::string name;
  ZoneKind kind{ZoneKind::no_go};
  geo::Polygon area;
  std::optional<core::UtcTime> from;   // empty: since ever
  std::optional<core::UtcTime> until;  // empty: for ever
  core::Metres top{0.0};
  core::Metres bottom{std::numeric_limits<double>::infinity()};
  std::optional<std::size_t> feature{};  // of the request, from 0: the parts of a MultiPolygon share it

  /// Empty when valid, otherwise all of them; fields are "/area", "/until", "/bottom_m".
  [[nodiscard]] core::Violations violations() const;
  [[nodiscard]] bool is_permanent() const { return !from && !until; }
};

/// Whether the zone's rule concerns a vehicle that moves between these depths: a no-go zone that shares a depth
/// with it; a stay-in zone always.
[[nodiscard]] bool concerns(const Zone& zone, core::Metres shallowest, core::Metres deepest);

/// Whether a stay-in zone has room for a vehicle that moves between these depths.
[[nodiscard]] bool holds_depths(const Zone& zone, core::Metres shallowest, core::Metres deepest);

/// How many of the zones, from the first on, are parts of its feature; one where it names none.
/// zones    at least one, in the order of the request
[[nodiscard]] std::size_t parts_of_first(std::span<const Zone> zones);

/// "no_go", "stay_in", and back.
[[nodiscard]] std::string zone_kind_name(ZoneKind kind);
[[nodiscard]] std::optional<ZoneKind> parse_zone_kind(const std::string& name);

}  // namespace floeplan::ocean
