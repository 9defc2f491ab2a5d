#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::ocean {

/// Size classes of the International Ice Patrol and the Canadian Ice Service, by waterline length.
/// Source  Environment Canada, MANICE chapter 4: growler < 5 m, bergy bit 5-15 m, small 15-60 m, medium
/// 61-120 m,
///         large 121-200 m, very large > 200 m
enum class IcebergSize { growler, bergy_bit, small, medium, large, very_large, unknown, radar_target };

/// The place of an iceberg at a time.
struct IcebergFix {
  geo::LonLat place;
  core::UtcTime time;

  friend bool operator==(const IcebergFix&, const IcebergFix&) = default;
};

/// One sighting of an iceberg.
struct Iceberg {
  std::string id;  // name or number in its source; all sightings of one berg have the same
  geo::LonLat place;
  core::UtcTime observed;
  IcebergSize size{IcebergSize::unknown};
  std::optional<core::Metres> length;                // at the waterline; empty: not in the source
  std::optional<core::Metres> draft;                 // empty: not in the source
  std::optional<core::Metres> position_uncertainty;  // empty: not in the source
  std::string shape;                                 // code of the source ("TAB", "DOM"); empty: not given
  std::string method;                                // how it was seen ("R/V", "SAT-HIGH"); empty: not given
  std::vector<IcebergFix> earlier{};                 // earlier sightings of this berg, oldest first
  std::optional<core::UtcTime> too_old_from{};  // too old for departures from then on; empty: never too old

  friend bool operator==(const Iceberg&, const Iceberg&) = default;
};

/// The length assumed for safety: the stated one, otherwise the upper end of the size class. An unknown size
/// (also a radar target) counts as very large. Very large without a stated length counts as 300 m.
[[nodiscard]] core::Metres safe_length(const Iceberg& iceberg);

/// Whether the sighting is too old for a departure at this time.
[[nodiscard]] bool is_too_old(const Iceberg& iceberg, core::UtcTime depart);

/// Name of the class in messages and files ("growler", "bergy_bit", ...), and the class of a name.
[[nodiscard]] std::string size_name(IcebergSize size);
[[nodiscard]] std::optional<IcebergSize> parse_size(const std::string& name);

}  // namespace floeplan::ocean
