#pragma once

#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"

namespace floeplan::ingest {

/// Which points are water, as a model's mask says; all where it has none.
class WaterMask {
 public:
  WaterMask() = default;
  explicit WaterMask(std::vector<bool> water) : water_{std::move(water)} {}

  [[nodiscard]] bool is_water(std::size_t point) const { return water_.empty() || water_[point]; }
  /// Makes land missing.
  void apply(std::vector<double>& values) const;
  /// Empty: all is water.
  [[nodiscard]] const std::vector<bool>& water() const { return water_; }

 private:
  std::vector<bool> water_;
};

/// Of a mask of all the model's centres that of those that have all their points.
[[nodiscard]] WaterMask whole_centres_of(const Staggering& staggering, const WaterMask& all);

/// The mask of this name over a variable's own plane.
[[nodiscard]] Checked<WaterMask> mask_over(const NetcdfFiles& files, const NetcdfVariable& variable,
                                           PlaneDimensions plane, std::string_view name);

/// Water where a mask's value is nearer to one than to zero, as every model writes it; also when it was packed.
[[nodiscard]] std::vector<bool> water_of(const std::vector<double>& mask);

}  // namespace floeplan::ingest
