#include "storage/ingest/readers/velocity/velocity_component.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/messages/ingest_velocity_messages.hpp"
#include "storage/ingest/common/in_blocks.hpp"
#include "storage/ingest/notation/cf_units.hpp"

namespace floeplan::ingest {
namespace {

/// All undeclared marks of missing values are larger.
constexpr double below_markers = 500.0;

/// Whether a value is a common mark for "missing" that the file does not declare. It must also be too large
/// for a current.
bool is_undeclared_fill(double value, double factor) {
  constexpr std::array markers{999.0, 9999.0, 99999.0, 32767.0, 32768.0};
  if (std::abs(value) * factor <= max_speed_m_s) return false;
  return std::abs(value) >= 1e10 ||
         std::find(markers.begin(), markers.end(), std::abs(value)) != markers.end();
}

/// The declared valid range, unpacked. CF defines it in packed values, but many files state it unpacked.
/// Limits that are possible speeds of water or air are taken as unpacked, because no file packs a speed in so
/// few steps. A range on one side of zero is ignored, because a component has both signs.
Extent valid_range_of(const NetcdfVariable& variable, double factor) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double most_m_s = 300.0;
  const auto end = [&](const char* alone, std::size_t of_both, double otherwise) {
    const auto both = variable.numbers("valid_range");
    const auto one = variable.numbers(alone);
    return one.size() == 1 ? one.front() : both.size() == 2 ? both[of_both] : otherwise;
  };
  const Extent range{end("valid_min", 0, -infinite), end("valid_max", 1, infinite)};
  const auto is_speed = [&](double value) {
    return std::isinf(value) || std::abs(value) * factor <= most_m_s;
  };
  if (!(range.least < 0.0 && range.greatest > 0.0)) return {-infinite, infinite};
  // A float32 value in the file may exceed the decimal limit by rounding.
  constexpr double slack = 1e-6;
  if (is_speed(range.least) && is_speed(range.greatest)) return {range.least - slack, range.greatest + slack};
  const auto unpacked = [&](double value) { return value * variable.scale() + variable.offset(); };
  const auto [least, greatest] = std::minmax({unpacked(range.least), unpacked(range.greatest)});
  return {least - slack, greatest + slack};
}

/// Metres per second per (unpacked) unit of the variable. A variable without a unit is read as m/s, with a
/// warning; its values must then be of a plausible size.
Checked<double> speed_factor_of(const NetcdfVariable& variable, Messages& warnings) {
  const std::string unit = variable.attribute("units");
  if (unit.empty()) {
    warnings.push_back(messages::ingest_velocity_message<"speed-without-unit">(variable.name()));
    return 1.0;
  }
  if (const auto factor = speed_factor(unit)) return *factor;
  return refuse(messages::ingest_velocity_message<"speed-unit-unknown">(variable.name(), unit));
}

}  // namespace

Checked<VelocityComponent> VelocityComponent::of(const NetcdfFile& file, const NetcdfVariable& variable,
                                                 NetcdfLayout layout, Messages& warnings) {
  const auto factor = speed_factor_of(variable, warnings);
  if (!factor) return refuse(factor.error());
  VelocityComponent component;
  component.variable_ = &variable;
  component.flags_ = GridFlags{file, variable, layout, warnings};
  component.layout_ = std::move(layout);
  component.factor_ = *factor;
  component.valid_ = valid_range_of(variable, *factor);
  return component;
}

repository::SampleSteps VelocityComponent::steps() const {
  return {variable_->scale() * factor_, variable_->offset() * factor_};
}

Checked<ComponentSlice> VelocityComponent::read(std::size_t time, std::size_t level) const {
  auto values = read_slice(*variable_, layout_, time, level);
  if (!values) return refuse(values.error());
  ComponentSlice slice{.values = std::move(*values)};
  const double factor = factor_;
  const Extent valid = valid_;
  const Extent plain{std::max(valid.least, -below_markers), std::min(valid.greatest, below_markers)};
  in_blocks(slice.values.size(), [&](std::size_t first, auto count) {
    double* const some = slice.values.data() + first;
    bool doubtful = false;
    for (std::size_t i = 0; i < count; ++i)
      doubtful |= (some[i] < plain.least) | (some[i] > plain.greatest);  // NaN is neither
    for (std::size_t i = 0; doubtful && i < count; ++i) {
      if (std::isnan(some[i])) continue;
      if (!is_undeclared_fill(some[i], factor) && valid.contains(some[i])) continue;
      ++slice.undeclared_fill;
      some[i] = std::numeric_limits<double>::quiet_NaN();
    }
    for (std::size_t i = 0; i < count; ++i) some[i] *= factor;
  });
  if (flags_.empty()) return slice;
  auto bad = flags_.bad_among(slice.values, time, level, slice.flagged);
  if (!bad) return refuse(bad.error());
  slice.bad = std::move(*bad);
  for (std::size_t i = 0; i < slice.values.size(); ++i)
    if (slice.bad[i]) slice.values[i] = std::numeric_limits<double>::quiet_NaN();
  return slice;
}

}  // namespace floeplan::ingest
