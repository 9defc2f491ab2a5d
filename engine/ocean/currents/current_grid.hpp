#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/ocean/currents/current_column.hpp"
#include "engine/ocean/currents/current_field.hpp"
#include "engine/ocean/currents/tidal_currents.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::ocean {

/// Currents of a model or a measurement on a grid; bilinear in place, linear in depth and in time.
/// Shape    u and v are [time][depth][y][x], last index fastest, m/s towards true east and true north (never along
///          the axes of a projected grid). NaN marks a missing sample inside the arrays; it never leaves the class
/// Outside  nullopt where any of the nodes needed is missing, beyond the grid, its depths and its times. From the
///          surface to the first level the current is that level's, as in a CurrentColumn. Data without a depth axis
///          (`depths` empty) answer for every depth: they say nothing of depth
/// Tide     where tidal currents are added, the steps of time are theirs: the data, linear between their own times
///          (steady when they have one), and the tide at each of its steps; nullopt also where the tide is missing
/// Threads  const members may be called from several threads at once
/// Errors   std::invalid_argument from the constructor when the sizes do not agree, or when the tide begins before or
///          ends after data of several times
class CurrentGrid : public CurrentField {
 public:
  struct Samples {
    HorizontalGrid grid;
    std::optional<Axis> depths_m;  // positive down; empty: the data have no depth axis
    Axis times_s;                  // seconds since 1970-01-01T00:00:00Z
    std::vector<float> u;
    std::vector<float> v;
  };

  explicit CurrentGrid(Samples samples);
  /// `tide` is on the nodes of the samples' grid; null: none.
  CurrentGrid(Samples samples, std::shared_ptr<const TidalCurrents> tide);

  [[nodiscard]] std::optional<geo::VelocityEn> at(geo::LonLat place, core::Metres depth,
                                                  core::UtcTime time) const override;
  /// Mean over the depths from the surface to `dive_depth`, by trapezoids over the levels that have water;
  /// levels below the bottom are left out. Data with one level or none answer with that level.
  [[nodiscard]] std::optional<geo::VelocityEn> depth_average(geo::LonLat place, core::Metres dive_depth,
                                                             std::size_t time_index) const;
  /// All levels with water at a node of the grid, down to the first one without; empty over land. Data without
  /// a depth axis give a column that is the same at every depth.
  [[nodiscard]] std::optional<CurrentColumn> column_at_node(std::size_t ix, std::size_t iy,
                                                            std::size_t time_index) const;
  [[nodiscard]] const Samples& samples() const { return samples_; }
  /// The steps of time that a `time_index` counts.
  [[nodiscard]] const Axis& times_s() const { return tide_ ? tide_->times_s() : samples_.times_s; }
  [[nodiscard]] const std::shared_ptr<const TidalCurrents>& tide() const { return tide_; }
  /// Whether the same samples are missing at every time; not told of grids with a tide. The first to ask has all
  /// samples looked at.
  [[nodiscard]] bool has_steady_gaps() const;
  /// The mean over all times, without the tide, as a field with a single time; a node is missing where it is missing
  /// at any time.
  [[nodiscard]] CurrentGrid time_mean() const;

 private:
  [[nodiscard]] std::optional<geo::VelocityEn> sampled(const GridPosition& at, std::size_t sample_time,
                                                       std::size_t depth_index) const;
  [[nodiscard]] std::optional<geo::VelocityEn> level(const GridPosition& at, std::size_t time_index,
                                                     std::size_t depth_index) const;
  /// Still where there is no tide.
  [[nodiscard]] std::optional<geo::VelocityEn> tide_at(const GridPosition& at, std::size_t time_index) const;
  [[nodiscard]] std::optional<CurrentColumn> column(const GridPosition& at, std::size_t time_index) const;

  [[nodiscard]] bool look_for_steady_gaps() const;

  struct Gaps {
    std::once_flag looked;
    bool are_steady{};
  };

  Samples samples_;
  std::shared_ptr<Gaps> gaps_;  // of copies too: they have the same samples
  std::shared_ptr<const TidalCurrents> tide_;
  std::vector<AxisPosition> sample_times_;  // where each step of the tide lies among the samples' times
};

}  // namespace floeplan::ocean
