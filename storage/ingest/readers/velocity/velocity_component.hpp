#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/grid_flags.hpp"
#include "storage/ingest/formats/netcdf/missing_marks.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/repository/encoding/sample_steps.hpp"

namespace floeplan::ingest {

inline constexpr double max_speed_m_s = 10.0;  // the strongest tidal races run at about 10 m/s

/// Values of one component in metres per second.
struct ComponentSlice {
  std::vector<double> values;  // [y][x] in the layout's order, NaN where missing
  std::int64_t undeclared_fill{};
  FlagCount flagged{};
  std::vector<bool> bad{};  // values missing because of their quality flags; empty: none

  [[nodiscard]] bool is_bad(std::size_t point) const { return !bad.empty() && bad[point]; }
};

/// One component of a velocity, with its unit, valid range and quality flags.
class VelocityComponent {
 public:
  /// `file`  the file with the variable and its quality flags
  /// Errors  a unit that is not a speed
  [[nodiscard]] static Checked<VelocityComponent> of(const NetcdfFile& file, const NetcdfVariable& variable,
                                                     NetcdfLayout layout, Messages& warnings);

  [[nodiscard]] const NetcdfLayout& layout() const { return layout_; }
  [[nodiscard]] const NetcdfVariable& variable() const { return *variable_; }
  [[nodiscard]] std::size_t columns() const { return layout_.x.source.size(); }
  [[nodiscard]] std::size_t rows() const { return layout_.y.source.size(); }
  /// Steps of packed values, in metres per second; empty if the variable is not packed in whole numbers.
  [[nodiscard]] repository::SampleSteps steps() const;
  /// Reads a slice. Missing, and counted, are: values that producers use for "missing" without declaring it,
  /// values outside the valid range, and values with a bad quality flag (see QualityFlags).
  [[nodiscard]] Checked<ComponentSlice> read(std::size_t time, std::size_t level) const;

 private:
  const NetcdfVariable* variable_{nullptr};  // borrowed
  NetcdfLayout layout_;
  double factor_{1.0};  // metres per second per unit of the variable
  Extent valid_;        // valid range, in the variable's unit
  GridFlags flags_;
};

}  // namespace floeplan::ingest
