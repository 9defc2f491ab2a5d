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

/// The points at which a source knows the currents, its levels and its times.
struct SourceShape {
  std::size_t columns{};  // points are numbered [row][column]
  std::size_t rows{1};    // 1: the points are in no order (a mesh)
  std::size_t levels{1};  // from the surface down
  std::vector<double> times_s;
  std::optional<std::vector<double>> depths_m;  // of the levels, where they are the same at every point
  bool levels_follow_bed{false};                // then level_depths() tells where each level lies

  [[nodiscard]] std::size_t points() const { return columns * rows; }
};

/// Currents of one level at one time, m/s towards true east and true north; NaN where missing.
struct VelocitySlice {
  std::vector<float> east;
  std::vector<float> north;
  std::int64_t undeclared_fill{};        // values taken as missing although the file does not say so
  repository::SampleSteps east_steps{};  // in which the file counts them, if it does
  repository::SampleSteps north_steps{};
  FlagCount flagged{};  // by the file's own quality flags; the bad ones are missing
};

/// Currents of one file or of several as their model has them: whatever the layout, brought to one set of points
/// and turned to true east and north, one level at a time.
/// Threads  one thread at a time
class VelocitySource {
 public:
  virtual ~VelocitySource() = default;
  [[nodiscard]] virtual const SourceShape& shape() const = 0;
  [[nodiscard]] virtual geo::LonLat place(std::size_t point) const = 0;
  /// Errors  the file can no longer be read
  [[nodiscard]] virtual Checked<VelocitySlice> read(std::size_t time, std::size_t level) const = 0;
  /// Depth of a level below the surface of the sea at every point, metres, NaN over land; the level after the
  /// last is the sea bed. Only where the levels follow the bed.
  [[nodiscard]] virtual Checked<std::vector<float>> level_depths(std::size_t time,
                                                                 std::size_t level) const = 0;
};

}  // namespace floeplan::ingest
