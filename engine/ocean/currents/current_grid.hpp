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
/// Shape    u and v are [time][depth][y][x], last index fastest, m/s towards true east and true north (never
///          along the axes of a projected grid). NaN marks a missing sample inside the arrays; no function
///          returns it
/// Outside  nullopt if a needed node is missing, and outside the grid, its depths and its times. From the
///          surface to the first level the current is that of this level, as in a CurrentColumn. Data without
///          a depth axis (`depths` empty) are valid at every depth
/// Tide     with a tide, the time steps are those of the tide. The current is the data, linear between their
///          own times (steady if they have one), plus the tide; nullopt also where the tide is missing
/// Added    a current that is the same at every depth may be added to the data, for example an error
/// Copies   share the samples
/// Threads  const members may be called from several threads at once
/// Errors   std::invalid_argument from the constructor if the sizes of the arrays differ, or if data have
///          several times and the tide begins before or ends after them
class CurrentGrid : public CurrentField {
 public:
  struct Samples {
    HorizontalGrid grid;
    std::optional<Axis> depths_m;  // positive down; empty: the data have no depth axis
    Axis times_s;                  // seconds since 1970-01-01T00:00:00Z
    std::vector<float> u;
    std::vector<float> v;
  };

  /// A current at each node and time of the samples, the same at every depth. Shape: [time][y][x], m/s.
  struct Added {
    std::vector<float> u;
    std::vector<float> v;
  };

  explicit CurrentGrid(Samples samples);
  /// `tide` has the nodes of the samples' grid; null: no tide.
  CurrentGrid(Samples samples, std::shared_ptr<const TidalCurrents> tide);
  /// The same currents with this one in place of what was added before.
  /// Errors  std::invalid_argument if the sizes of its arrays differ from those of one level of the samples
  [[nodiscard]] CurrentGrid with_added(Added added) const;

  [[nodiscard]] std::optional<geo::VelocityEn> at(geo::LonLat place, core::Metres depth,
                                                  core::UtcTime time) const override;
  /// Mean over the depths from the surface to `dive_depth`, by the trapezoidal rule over the levels with
  /// water. For data with one level or without levels, the value of that level.
  [[nodiscard]] std::optional<geo::VelocityEn> depth_average(geo::LonLat place, core::Metres dive_depth,
                                                             std::size_t time_index) const;
  /// All levels with water at a node of the grid, down to the first level without; empty over land. For data
  /// without a depth axis the column is the same at every depth.
  [[nodiscard]] std::optional<CurrentColumn> column_at_node(std::size_t ix, std::size_t iy,
                                                            std::size_t time_index) const;
  /// The data alone, without the tide and without what was added.
  [[nodiscard]] const Samples& samples() const { return *samples_; }
  /// The time steps to which a `time_index` refers.
  [[nodiscard]] const Axis& times_s() const { return tide_ ? tide_->times_s() : samples_->times_s; }
  [[nodiscard]] const std::shared_ptr<const TidalCurrents>& tide() const { return tide_; }
  [[nodiscard]] const std::shared_ptr<const Added>& added() const { return added_; }
  /// Whether the same samples are missing at every time; false for grids with a tide. The first call checks
  /// all samples.
  [[nodiscard]] bool has_steady_gaps() const;
  /// The mean of the data over all times, without the tide, as a grid with a single time. A node is missing if it is
  /// missing at any time.
  [[nodiscard]] CurrentGrid time_mean() const;

 private:
  [[nodiscard]] std::optional<geo::VelocityEn> sampled(const GridPosition& at, std::size_t sample_time,
                                                       std::size_t depth_index) const;
  [[nodiscard]] std::optional<geo::VelocityEn> level(const GridPosition& at, std::size_t time_index,
                                                     std::size_t depth_index) const;
  /// Zero if the grid has no tide.
  [[nodiscard]] std::optional<geo::VelocityEn> tide_at(const GridPosition& at, std::size_t time_index) const;
  [[nodiscard]] std::optional<CurrentColumn> column(const GridPosition& at, std::size_t time_index) const;

  [[nodiscard]] bool look_for_steady_gaps() const;

  struct Gaps {
    std::once_flag looked;
    bool are_steady{};
  };

  std::shared_ptr<const Samples> samples_;
  std::shared_ptr<Gaps> gaps_;
  std::shared_ptr<const TidalCurrents> tide_;
  std::shared_ptr<const Added> added_;
  std::vector<AxisPosition> sample_times_;  // position of each tidal time step among the times of the samples
};

}  // namespace floeplan::ocean
