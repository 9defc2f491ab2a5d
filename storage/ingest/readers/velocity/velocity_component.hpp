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

/// Numbers of one component in metres per second.
struct ComponentSlice {
  std::vector<double> values;  // [y][x] in the layout's order, NaN where missing
  std::int64_t undeclared_fill{};
  FlagCount flagged{};
  std::vector<bool> bad{};  // what is missing because flags forbid its use; empty: nothing

  [[nodiscard]] bool is_bad(std::size_t point) const { return !bad.empty() && bad[point]; }
};

/// One component of a velocity and how it is read.
class VelocityComponent {
 public:
  /// `file`  of the variable and its quality flags
  /// Errors  a unit that is no speed
  [[nodiscard]] static Checked<VelocityComponent> of(const NetcdfFile& file, const NetcdfVariable& variable,
                                                     NetcdfLayout layout, Messages& warnings);

  [[nodiscard]] const NetcdfLayout& layout() const { return layout_; }
  [[nodiscard]] const NetcdfVariable& variable() const { return *variable_; }
  [[nodiscard]] std::size_t columns() const { return layout_.x.source.size(); }
  [[nodiscard]] std::size_t rows() const { return layout_.y.source.size(); }
  /// In metres per second; of numbers that are not packed whole ones.
  [[nodiscard]] repository::SampleSteps steps() const;
  /// Numbers that producers write for "missing" without declaring them, and those outside the variable's valid range,
  /// are missing and counted; so is what quality flags call bad (see QualityFlags).
  [[nodiscard]] Checked<ComponentSlice> read(std::size_t time, std::size_t level) const;

 private:
  const NetcdfVariable* variable_{nullptr};  // borrowed
  NetcdfLayout layout_;
  double factor_{1.0};  // metres per second in one of the variable's unit
  Extent valid_;        // in the variable's unit
  GridFlags flags_;
};

}  // namespace floeplan::ingest
