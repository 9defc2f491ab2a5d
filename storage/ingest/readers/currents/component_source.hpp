#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "engine/ocean/grids/staggered_sampling.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/staggering.hpp"
#include "storage/ingest/grids/water_mask.hpp"
#include "storage/ingest/readers/currents/zero_land.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"
#include "storage/repository/encoding/sample_steps.hpp"

namespace floeplan::ingest {

/// A velocity on a staggered or bent grid as its file has it.
struct GridComponents {
  NetcdfFiles files;  // kept open
  VelocityComponent first;
  VelocityComponent second;
  Staggering staggering;
  WaterMask first_mask;
  WaterMask second_mask;
  WaterMask centre_mask;                    // of all the model's centres
  std::shared_ptr<const BedLevels> levels;  // at all centres; null: the levels are depths, or there are none

  /// One level of both components at one time, m/s along the axis of each; without a value where a mask says land.
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<std::pair<ComponentSlice, ComponentSlice>> read(std::size_t time,
                                                                        std::size_t level) const;
};

/// The components of one level at one time, m/s along the axis of each.
struct PointComponents {
  std::vector<float> values;        // at the first component's points, then at the second's
  repository::SampleSteps steps{};  // in which the file counts them, if it does
};

/// The two components of a C grid at points of their own: the faces between the model's cells.
/// A face between two cells with water has the file's own value. One between water and land is closed: no water flows
/// through it, and its value is 0, whatever the file has there. One between two cells of land, and one that flags forbid
/// to use, has none. Land is what a mask says, what the file holds as zeros or a cell without a known face.
/// Threads  one thread at a time
class ComponentSource {
 public:
  /// So many points has the part of each component's plane that has places, [row][column] from the plane's first one on.
  struct Planes {
    std::size_t first_rows{};
    std::size_t first_columns{};
    std::size_t second_rows{};
    std::size_t second_columns{};
  };

  /// Precondition  the components are not collocated
  ComponentSource(std::shared_ptr<const GridComponents> parts, Planes planes, ocean::ComponentAxes axes)
      : parts_{std::move(parts)}, planes_{planes}, axes_{std::move(axes)} {}

  /// The same with one level alone.
  [[nodiscard]] ComponentSource of_level(std::size_t level) const;

  [[nodiscard]] const ocean::ComponentAxes& axes() const { return axes_; }
  /// `land`  that was found in the zeros of the file; null: none
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<PointComponents> read(std::size_t time, std::size_t level,
                                              const ZeroLand* land) const;
  /// As VelocitySource has it: the mean of the centres on either side of a point, beside a coast that of the water; of the
  /// sea bed the deeper one, so that each cell has currents down to its own bed.
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const;

 private:
  /// Calls `visit(point, sample, centres)` for each point of the first component, then of the second; `sample` counts in
  /// that component's plane.
  template <class First, class Second>
  void for_each_point(const First& of_first, const Second& of_second) const;
  [[nodiscard]] std::size_t points() const { return axes_.first_rad.size(); }

  std::shared_ptr<const GridComponents> parts_;
  Planes planes_;
  ocean::ComponentAxes axes_;
  std::size_t first_level_{0};
};

}  // namespace floeplan::ingest
