#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

inline constexpr double max_bed_depth_m = 12000.0;  // the deepest sea has 11 km

/// Where the levels of a model lie that follow the sea bed.
/// Threads  one thread at a time
class BedLevels {
 public:
  virtual ~BedLevels() = default;
  /// Depth below the surface of the sea (not below its mean) of a level at every point, metres, NaN over land.
  /// Levels count from the surface down, the one after the last is the sea bed.
  [[nodiscard]] virtual Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const = 0;
  /// Index in the file of a level counted from the surface down.
  [[nodiscard]] virtual std::size_t file_level(std::size_t level) const = 0;
};

}  // namespace floeplan::ingest
