#include "storage/ingest/formats/netcdf/measurement_line.hpp"

#include <algorithm>
#include <limits>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

std::optional<MeasurementLine> MeasurementLine::of(const NetcdfFile& file, const NetcdfVariable* variable) {
  if (variable == nullptr || !variable->is_numeric() || variable->dimensions().empty()) return std::nullopt;
  const auto& dimensions = variable->dimensions();
  const auto is_long = [](const NetcdfDimension& dimension) { return dimension.size > 1; };
  if (std::ranges::count_if(dimensions, is_long) > 1) return std::nullopt;
  const auto longest = std::ranges::find_if(dimensions, is_long);
  MeasurementLine line;
  line.variable_ = variable;
  line.axis_ = longest != dimensions.end() ? static_cast<std::size_t>(longest - dimensions.begin())
                                           : dimensions.size() - 1;
  line.flags_ = quality_flags_of(file, *variable);
  return line;
}

Checked<std::vector<double>> MeasurementLine::packed(const NetcdfVariable& variable, std::uint64_t first,
                                                     std::size_t count) const {
  std::vector<std::uint64_t> start(variable.dimensions().size(), 0);
  std::vector<std::size_t> counts(variable.dimensions().size(), 1);
  start[axis_] = first;
  counts[axis_] = count;
  return variable.read_packed(start, counts);
}

Checked<std::vector<double>> MeasurementLine::read(std::uint64_t first, std::size_t count) const {
  auto values = packed(*variable_, first, count);
  if (!values) return values;
  for (double& value : *values) value = variable_->unpacked(value);
  for (const QualityFlags& flags : flags_) {
    const auto worth = packed(*flags.variable, first, count);
    if (!worth) return worth;
    for (std::size_t i = 0; i < count; ++i)
      if (flags.forbids((*worth)[i])) (*values)[i] = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

const NetcdfVariable* find_measured(const NetcdfFile& file, const std::vector<std::string_view>& names,
                                    const std::vector<std::string_view>& standard_names) {
  for (const std::string_view name : names)
    for (const NetcdfVariable& variable : file.variables())
      if (lower(variable.name()) == name && variable.is_numeric()) return &variable;
  for (const std::string_view name : standard_names)
    for (const NetcdfVariable& variable : file.variables())
      if (lower(variable.attribute("standard_name")) == name && variable.is_numeric()) return &variable;
  return nullptr;
}

}  // namespace floeplan::ingest
