#include "storage/ingest/velocity_component.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "storage/ingest/velocity_pair.hpp"

namespace floeplan::ingest {
namespace {

/// Numbers that producers write for "missing" without declaring them, when they are also too large for a
/// current.
bool is_undeclared_fill(double value, double factor) {
  constexpr std::array markers{999.0, 9999.0, 99999.0, 32767.0, 32768.0};
  if (std::abs(value) * factor <= max_speed_m_s) return false;
  return std::abs(value) >= 1e10 ||
         std::find(markers.begin(), markers.end(), std::abs(value)) != markers.end();
}

}  // namespace

Checked<VelocityComponent> VelocityComponent::of(const NetcdfVariable& variable, NetcdfLayout layout,
                                                 std::vector<std::string>& warnings) {
  const auto factor = speed_factor_of(variable, warnings);
  if (!factor) return refuse(factor.error());
  VelocityComponent component;
  component.variable_ = &variable;
  component.layout_ = std::move(layout);
  component.factor_ = *factor;
  return component;
}

Checked<ComponentSlice> VelocityComponent::read(std::size_t time, std::size_t level) const {
  auto values = read_slice(*variable_, layout_, time, level);
  if (!values) return refuse(values.error());
  ComponentSlice slice{std::move(*values), 0};
  for (double& value : slice.values) {
    if (std::isnan(value)) continue;
    if (is_undeclared_fill(value, factor_)) {
      ++slice.undeclared_fill;
      value = std::numeric_limits<double>::quiet_NaN();
    } else {
      value *= factor_;
    }
  }
  return slice;
}

}  // namespace floeplan::ingest
