#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/grid_flags.hpp"
#include "storage/repository/encoding/sample_steps.hpp"

namespace floeplan::ingest {

/// The points, levels and times at which a source has currents.
struct SourceShape {
  std::size_t columns{};  // points are numbered [row][column]
  std::size_t rows{1};    // 1: the points have no rows (a mesh)
  std::size_t levels{1};  // number of levels, from the surface down
  std::vector<double> times_s;
  std::optional<std::vector<double>> depths_m;  // depths of the levels, if they are the same at every point
  bool levels_follow_bed{false};                // true: level_depths() gives the depth of each level

  [[nodiscard]] std::size_t points() const { return columns * rows; }
};

/// Currents of one level at one time, m/s towards true east and true north; NaN where missing.
struct VelocitySlice {
  std::vector<float> east;
  std::vector<float> north;
  // values that count as missing although the file does not declare them so
  std::int64_t undeclared_fill{};
  repository::SampleSteps east_steps{};  // steps in which the file stores the values, if they are packed
  repository::SampleSteps north_steps{};
  FlagCount flagged{};  // values with the file's own quality flags; the bad ones are missing
};

/// Currents of one file or several files, whatever the layout of their model: both components at the same
/// points, rotated to true east and north, one level at a time.
/// Threads  one thread at a time
class VelocitySource {
 public:
  virtual ~VelocitySource() = default;
  [[nodiscard]] virtual const SourceShape& shape() const = 0;
  [[nodiscard]] virtual geo::LonLat place(std::size_t point) const = 0;
  /// Errors  the file can no longer be read
  [[nodiscard]] virtual Checked<VelocitySlice> read(std::size_t time, std::size_t level) const = 0;
  /// Depth of a level below the sea surface at every point, metres, NaN over land; the level after the last
  /// is the sea bed. Only for sources whose levels follow the bed.
  [[nodiscard]] virtual Checked<std::vector<float>> level_depths(std::size_t time,
                                                                 std::size_t level) const = 0;
};

}  // namespace floeplan::ingest
