#pragma once

#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/staggering.hpp"

namespace floeplan::ingest {

/// Which points are water, according to a model's mask; all points if the model has none.
class WaterMask {
 public:
  WaterMask() = default;
  explicit WaterMask(std::vector<bool> water) : water_{std::move(water)} {}

  [[nodiscard]] bool is_water(std::size_t point) const { return water_.empty() || water_[point]; }
  /// Sets the values on land to missing (NaN).
  void apply(std::vector<double>& values) const;
  /// Empty: all points are water.
  [[nodiscard]] const std::vector<bool>& water() const { return water_; }

 private:
  std::vector<bool> water_;
};

/// The mask of the centres that have all their points, from the mask of all centres.
[[nodiscard]] WaterMask whole_centres_of(const Staggering& staggering, const WaterMask& all);

/// The mask with this name over a variable's own horizontal dimensions.
[[nodiscard]] Checked<WaterMask> mask_over(const NetcdfFiles& files, const NetcdfVariable& variable,
                                           PlaneDimensions plane, std::string_view name);

/// Water where a mask's value is nearer to one than to zero. All models use this convention; packed masks may
/// be inexact.
[[nodiscard]] std::vector<bool> water_of(const std::vector<double>& mask);

}  // namespace floeplan::ingest
