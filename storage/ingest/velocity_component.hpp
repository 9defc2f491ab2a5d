#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "storage/ingest/missing_marks.hpp"
#include "storage/ingest/netcdf_layout.hpp"
#include "storage/ingest/refusal.hpp"
#include "storage/repository/sample_steps.hpp"

namespace floeplan::ingest {

inline constexpr double max_speed_m_s = 10.0;  // the strongest tidal races run at about 10 m/s

/// Numbers of one component in metres per second.
struct ComponentSlice {
  std::vector<double> values;  // [y][x] in the layout's order, NaN where missing
  std::int64_t undeclared_fill{};
};

/// One component of a velocity and how it is read.
class VelocityComponent {
 public:
  /// Errors  a unit that is no speed
  [[nodiscard]] static Checked<VelocityComponent> of(const NetcdfVariable& variable, NetcdfLayout layout,
                                                     std::vector<std::string>& warnings);

  [[nodiscard]] const NetcdfLayout& layout() const { return layout_; }
  [[nodiscard]] const NetcdfVariable& variable() const { return *variable_; }
  [[nodiscard]] std::size_t columns() const { return layout_.x.source.size(); }
  [[nodiscard]] std::size_t rows() const { return layout_.y.source.size(); }
  /// In metres per second; of numbers that are not packed whole ones.
  [[nodiscard]] repository::SampleSteps steps() const;
  /// Numbers that producers write for "missing" without declaring them, and those outside the variable's valid range,
  /// are missing and counted.
  [[nodiscard]] Checked<ComponentSlice> read(std::size_t time, std::size_t level) const;

 private:
  const NetcdfVariable* variable_{nullptr};  // borrowed
  NetcdfLayout layout_;
  double factor_{1.0};  // metres per second in one of the variable's unit
  Extent valid_;        // in the variable's unit
};

}  // namespace floeplan::ingest
