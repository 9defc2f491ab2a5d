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

/// Where an iceberg was, and when.
struct IcebergFix {
  geo::LonLat place;
  core::UtcTime time;
};

/// One sighting of an iceberg.
struct Iceberg {
  std::string id;  // the berg's name or number in its source; sightings of one berg share it
  geo::LonLat place;
  core::UtcTime observed;
  IcebergSize size{IcebergSize::unknown};
  std::optional<core::Metres> length;                // at the waterline, where the source states it
  std::optional<core::Metres> draft;                 // where the source states it
  std::optional<core::Metres> position_uncertainty;  // where the source states it
  std::string shape;                            // the source's own code ("TAB", "DOM"), empty when not given
  std::string method;                           // how it was seen ("R/V", "SAT-HIGH"), empty when not given
  std::vector<IcebergFix> earlier{};            // sightings of the same berg before this one, oldest first
  std::optional<core::UtcTime> too_old_from{};  // to a vehicle that leaves then or later; empty: never
};

/// Length to keep clear of: the stated one, else the upper end of the size class. A size that is not known
/// (also a radar target) counts as very large, never as small. Very large without a stated length counts as
/// 300 m.
[[nodiscard]] core::Metres safe_length(const Iceberg& iceberg);

/// Whether the sighting is too old to count for a vehicle that leaves then.
[[nodiscard]] bool is_too_old(const Iceberg& iceberg, core::UtcTime depart);

/// The class's name in messages and files: "growler", "bergy_bit", ..., and back.
[[nodiscard]] std::string size_name(IcebergSize size);
[[nodiscard]] std::optional<IcebergSize> parse_size(const std::string& name);

}  // namespace floeplan::ocean
