#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/quality_flags.hpp"

namespace floeplan::ingest {

/// How many values carry flags.
struct FlagCount {
  std::int64_t bad{};
  std::int64_t doubtful{};
};

/// The counts for two components at the same points: of each kind the greater.
[[nodiscard]] inline FlagCount of_both(FlagCount a, FlagCount b) {
  return {std::max(a.bad, b.bad), std::max(a.doubtful, b.doubtful)};
}

/// The quality flags of a variable on a grid or a mesh.
class GridFlags {
 public:
  GridFlags() = default;
  /// Flags along all dimensions of the variable or along some, the plane among them. Told: flags whose meanings are not
  /// known, and those that cannot be read beside the values, which stay unflagged.
  /// `layout`  of the variable
  GridFlags(const NetcdfFile& file, const NetcdfVariable& variable, const NetcdfLayout& layout,
            Messages& warnings);

  [[nodiscard]] bool empty() const { return flags_.empty(); }
  /// For each value of a slice whether it is bad; values that are missing are none, and counted are neither.
  /// `values`  as read_slice gives them, NaN where missing
  [[nodiscard]] Checked<std::vector<bool>> bad_among(const std::vector<double>& values, std::size_t time,
                                                     std::size_t level, FlagCount& count) const;

 private:
  struct Flags {
    QualityFlags meaning;
    NetcdfLayout layout;  // of the flags, with the nodes of the variable
  };

  std::vector<Flags> flags_;
};

}  // namespace floeplan::ingest
