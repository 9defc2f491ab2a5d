#include "storage/ingest/grids/water_mask.hpp"

#include <cmath>
#include <limits>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

void WaterMask::apply(std::vector<double>& values) const {
  for (std::size_t i = 0; i < water_.size() && i < values.size(); ++i)
    if (!water_[i]) values[i] = std::numeric_limits<double>::quiet_NaN();
}

WaterMask whole_centres_of(const Staggering& staggering, const WaterMask& all) {
  return WaterMask{of_whole_centres(staggering, all.water())};
}

std::vector<bool> water_of(const std::vector<double>& mask) {
  std::vector<bool> water;
  water.reserve(mask.size());
  for (const double value : mask) water.push_back(value > 0.5);
  return water;
}

Checked<WaterMask> mask_over(const NetcdfFiles& files, const NetcdfVariable& variable, PlaneDimensions plane,
                             std::string_view name) {
  const NetcdfDimension& y = variable.dimensions()[plane.y];
  const NetcdfDimension& x = variable.dimensions()[plane.x];
  for (const auto& file : files) {
    for (const NetcdfVariable& mask : file->variables()) {
      if (lower(mask.name()) != name || mask.dimensions().size() != 2) continue;
      if (mask.dimensions()[0].size != y.size || mask.dimensions()[1].size != x.size) continue;
      const auto values = mask.read_all();
      if (!values) return refuse(values.error());
      return WaterMask{water_of(*values)};
    }
  }
  return WaterMask{};
}

}  // namespace floeplan::ingest
