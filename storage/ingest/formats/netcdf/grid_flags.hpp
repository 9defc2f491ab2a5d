#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/quality_flags.hpp"

namespace floeplan::ingest {

/// Numbers of values that are flagged as bad and as doubtful.
struct FlagCount {
  std::int64_t bad{};
  std::int64_t doubtful{};
};

/// The count for a vector of two components at the same points: the greater number of bad and of doubtful
/// values.
[[nodiscard]] inline FlagCount of_both(FlagCount a, FlagCount b) {
  return {std::max(a.bad, b.bad), std::max(a.doubtful, b.doubtful)};
}

/// The quality flags of a variable on a grid or a mesh.
class GridFlags {
 public:
  GridFlags() = default;
  /// Finds the flags that lie along all dimensions of the variable or some of them, the horizontal ones
  /// included. Warns of flags whose meanings are not known and of flags that cannot be read; their values
  /// count as not flagged.
  /// `layout`  of the variable
  GridFlags(const NetcdfFile& file, const NetcdfVariable& variable, const NetcdfLayout& layout,
            Messages& warnings);

  [[nodiscard]] bool empty() const { return flags_.empty(); }
  /// Whether each value of a slice is bad. A missing value is neither bad nor counted.
  /// `values`  as read_slice gives them, NaN where missing
  [[nodiscard]] Checked<std::vector<bool>> bad_among(const std::vector<double>& values, std::size_t time,
                                                     std::size_t level, FlagCount& count) const;

 private:
  struct Flags {
    QualityFlags meaning;
    NetcdfLayout layout;  // layout of the flags, with the nodes of the variable
  };

  std::vector<Flags> flags_;
};

}  // namespace floeplan::ingest
