#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

inline constexpr double max_bed_depth_m = 12000.0;  // the deepest sea has 11 km

/// Depths of model levels that follow the sea bed (terrain-following levels).
/// Threads  one thread at a time
class BedLevels {
 public:
  virtual ~BedLevels() = default;
  /// Depth of a level below the instantaneous sea surface (not below its mean) at every point, metres, NaN
  /// over land. Level 0 is the uppermost; the level after the last is the sea bed.
  [[nodiscard]] virtual Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const = 0;
  /// Index in the file of a level counted from the surface down.
  [[nodiscard]] virtual std::size_t file_level(std::size_t level) const = 0;
};

}  // namespace floeplan::ingest
