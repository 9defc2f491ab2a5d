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

/// A velocity on a staggered or curvilinear grid, in the arrangement of its file.
struct GridComponents {
  NetcdfFiles files;  // references that keep the files open
  VelocityComponent first;
  VelocityComponent second;
  Staggering staggering;
  WaterMask first_mask;
  WaterMask second_mask;
  WaterMask centre_mask;                    // water among all the model's centres
  std::shared_ptr<const BedLevels> levels;  // at all centres; null: the levels are depths, or there are none

  /// Both components of one level at one time, m/s along each component's axis; NaN where a mask says land.
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<std::pair<ComponentSlice, ComponentSlice>> read(std::size_t time,
                                                                        std::size_t level) const;
};

/// Components of one level at one time, m/s along the axis of each point.
struct PointComponents {
  std::vector<float> values;        // at the first component's points, then at the second's
  repository::SampleSteps steps{};  // steps in which the file stores the values, if they are packed
};

/// The two components of a C grid at their own points: the faces between the model's cells. A face between
/// two cells of water has the file's value. A face between water and land has the value 0, whatever the file
/// says, because no water flows through it. A face between two cells of land, or with a bad quality flag, has
/// no value. A cell is land if a mask or the file's zeros say so, or if none of its faces has a value.
/// Threads  one thread at a time
class ComponentSource {
 public:
  /// How many rows and columns of points with a position each component has, counted from its first point.
  struct Planes {
    std::size_t first_rows{};
    std::size_t first_columns{};
    std::size_t second_rows{};
    std::size_t second_columns{};
  };

  /// Precondition  the components are not collocated
  ComponentSource(std::shared_ptr<const GridComponents> parts, Planes planes, ocean::ComponentAxes axes)
      : parts_{std::move(parts)}, planes_{planes}, axes_{std::move(axes)} {}

  /// The same source reduced to one level.
  [[nodiscard]] ComponentSource of_level(std::size_t level) const;

  [[nodiscard]] const ocean::ComponentAxes& axes() const { return axes_; }
  /// `land`  land found from zeros in the file; null: none
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<PointComponents> read(std::size_t time, std::size_t level,
                                              const ZeroLand* land) const;
  /// Depth of a level at every point, as in VelocitySource: the mean of the centres on either side; beside a
  /// coast the depth on the water side. For the sea bed it is the deeper of the two, so that each cell has
  /// currents down to its own bed.
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const;

 private:
  /// Calls `of_first` or `of_second` with (point, sample, centres) for each point of the first component,
  /// then of the second. `sample` is the index among that component's values in the file.
  template <class First, class Second>
  void for_each_point(const First& of_first, const Second& of_second) const;
  [[nodiscard]] std::size_t points() const { return axes_.first_rad.size(); }

  std::shared_ptr<const GridComponents> parts_;
  Planes planes_;
  ocean::ComponentAxes axes_;
  std::size_t first_level_{0};
};

}  // namespace floeplan::ingest
