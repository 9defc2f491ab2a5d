#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

bool runs_along(const NetcdfVariable& variable, const NetcdfDimension& dimension) {
  return variable.is_numeric() && variable.dimensions().size() == 1 &&
         variable.dimensions().front().name == dimension.name;
}

bool is_scalar(const NetcdfVariable& variable) {
  return variable.is_numeric() &&
         std::ranges::all_of(variable.dimensions(),
                             [](const NetcdfDimension& dimension) { return dimension.size == 1; });
}

/// Whether a variable is a level by its standard name or axis. Its name and unit do not count: a scalar may
/// be anything.
bool declares_a_level(const NetcdfVariable& variable) {
  const std::string standard_name = lower(variable.attribute("standard_name"));
  return standard_name == "depth" || standard_name == "height" || standard_name == "altitude" ||
         standard_name == "air_pressure" || standard_name == "sea_water_pressure" ||
         variable.attribute("axis") == "Z";
}

/// Largest rounding error, in seconds, of times that were stored as float32.
double rounding_of_float32_s(const NetcdfVariable& coordinate, const std::vector<double>& values,
                             const CfTime& decoder) {
  if (!coordinate.is_float32() || values.empty()) return 0.0;
  const auto last = static_cast<float>(values.back());
  const auto at = decoder.at(static_cast<double>(last));
  const auto next = decoder.at(static_cast<double>(std::nextafter(last, 0.0F)));
  return at && next ? 0.5 * std::abs((*at - *next).count()) : 0.0;
}

/// Whether a variable declares by its attributes, not only by its name, what it measures along its dimension.
bool declares_its_role(const NetcdfVariable& variable) {
  const std::string unit = variable.attribute("units");
  const bool declared = !variable.attribute("standard_name").empty() || !variable.attribute("axis").empty() ||
                        is_degrees_east(unit) || is_degrees_north(unit);
  return declared && role_of(variable) != AxisRole::unknown;
}

}  // namespace

const NetcdfVariable* coordinate_of(const NetcdfFile& file, const NetcdfDimension& dimension) {
  const NetcdfVariable* named = file.find(dimension.name);
  if (named != nullptr && !runs_along(*named, dimension)) return nullptr;
  if (named != nullptr && role_of(*named) != AxisRole::unknown) return named;
  const NetcdfVariable* found = nullptr;
  for (const NetcdfVariable& variable : file.variables()) {
    if (!runs_along(variable, dimension) || !declares_its_role(variable)) continue;
    if (found != nullptr) return named;
    found = &variable;
  }
  return found != nullptr ? found : named;
}

const NetcdfVariable* heights_along(const NetcdfFile& file, const NetcdfDimension& levels) {
  for (const char* const name : {"zcor", "zCoordinates"}) {
    const NetcdfVariable* const table = file.find(name);
    if (table == nullptr || !table->is_numeric() || table->dimensions().size() < 2) continue;
    for (const NetcdfDimension& dimension : table->dimensions())
      if (dimension.name == levels.name) return table;
  }
  return nullptr;
}

Checked<AxisNodes> depth_nodes(const NetcdfVariable& coordinate, Messages& warnings) {
  auto values = coordinate.read_all();
  if (!values) return refuse(values.error());
  const std::string unit = coordinate.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse(messages::ingest_netcdf_message<"depth-axis-without-length">(coordinate.name(), unit));
  if (unit.empty())
    warnings.push_back(messages::ingest_netcdf_message<"axis-without-unit">("depth axis", coordinate.name()));

  const std::string positive = lower(coordinate.attribute("positive"));
  const std::string standard_name = lower(coordinate.attribute("standard_name"));
  const bool is_height = standard_name == "height" || standard_name == "altitude";
  const bool all_below_zero =
      std::all_of(values->begin(), values->end(), [](double v) { return v <= 0.0; }) &&
      std::any_of(values->begin(), values->end(), [](double v) { return v < 0.0; });
  // Tools for MITgcm write heights below zero and say "down"; nothing lies above the sea.
  const bool contradicts_itself = positive == "down" && all_below_zero;
  const bool up = positive == "up" || all_below_zero || (positive != "down" && is_height);
  const auto [least, greatest] = std::ranges::minmax(*values);
  const std::string stated = number(least, 9) + " to " + number(greatest, 9) +
                             (unit.empty() ? "" : " " + unit) + (up ? ", upwards" : ", downwards");
  if (contradicts_itself)
    warnings.push_back(messages::ingest_netcdf_message<"depths-negative-downwards">(
        coordinate.name(), number(least, 9) + " to " + number(greatest, 9)));
  for (double& value : *values) value *= up ? -*factor : *factor;
  for (double& value : *values)
    if (value == 0.0) value = 0.0;  // -0 becomes 0

  auto nodes = monotonic_nodes(coordinate.name(), std::move(*values));
  const bool above_ground = up && (is_height || contains_any(lower(coordinate.name()), {"height"}));
  if (nodes && !above_ground && (nodes->nodes.front() < -10.0 || nodes->nodes.back() > 12000.0))
    return refuse(messages::ingest_netcdf_message<"depths-impossible">(coordinate.name(), stated));
  return nodes;
}

Checked<AxisNodes> time_nodes(const NetcdfVariable& coordinate, Messages& warnings) {
  const std::string unit = coordinate.attribute("units");
  if (unit.empty()) return refuse(messages::ingest_netcdf_message<"times-without-units">(coordinate.name()));
  const auto decoder = CfTime::parse(unit, coordinate.attribute("calendar"));
  if (!decoder) return refuse(decoder.error());
  const auto values = coordinate.read_all();
  if (!values) return refuse(values.error());

  std::vector<double> seconds;
  for (const double value : *values) {
    const auto time = decoder->at(value);
    if (!time) return refuse(time.error());
    seconds.push_back(core::unix_seconds(*time));
  }
  if (const double rounding_s = rounding_of_float32_s(coordinate, *values, *decoder); rounding_s > 1.0)
    warnings.push_back(
        messages::ingest_netcdf_message<"times-rounded">(static_cast<int>(std::ceil(rounding_s))));
  if (decoder->is_julian()) warnings.push_back(messages::ingest_netcdf_message<"julian-calendar">());
  if (decoder->is_model_calendar())
    warnings.push_back(messages::ingest_netcdf_message<"model-calendar">(coordinate.attribute("calendar")));
  return sorted_nodes(coordinate.name(), std::move(seconds));
}

const NetcdfVariable* scalar_time(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables()) {
    std::uint64_t size = 1;
    for (const NetcdfDimension& dimension : variable.dimensions()) size *= dimension.size;
    const std::string standard_name = lower(variable.attribute("standard_name"));
    const bool named = standard_name == "time" || (standard_name.empty() && lower(variable.name()) == "time");
    if (size == 1 && variable.is_numeric() && named) return &variable;
  }
  return nullptr;
}

bool cannot_be_placed(const NetcdfVariable& levels) {
  if (role_of(levels) != AxisRole::other_level) return false;
  constexpr std::string_view of_numbers[]{"", "1", "level", "levels", "layer", "layers", "count"};
  const bool number_alone =
      levels.attribute("standard_name").empty() &&
      std::ranges::find(of_numbers, lower(levels.attribute("units"))) != std::end(of_numbers);
  return !number_alone || !is_scalar(levels);
}

messages::Message not_in_metres(const NetcdfVariable& levels, const std::string& variable) {
  const std::string standard_name = lower(levels.attribute("standard_name"));
  if (contains_any(standard_name, {"sea_floor"}))
    return messages::ingest_netcdf_message<"levels-above-the-bed">(variable, levels.name());
  const std::string unit = levels.attribute("units");
  const bool follows_ground = contains_any(standard_name, {"sigma", "hybrid", "model_level"});
  const bool is_number = unit == "1" || lower(unit).starts_with("level");
  const std::string what = follows_ground || is_number ? "numbers of the model's levels"
                           : contains_any(standard_name, {"pressure"}) || is_pressure_unit(unit) ? "pressures"
                           : unit.empty() ? "in no unit that the file states"
                                          : "in the unit \"" + unit + "\", not in metres";
  return messages::ingest_netcdf_message<"levels-without-depths">(variable, levels.name(), what);
}

const NetcdfVariable* level_beside(const NetcdfFile& file, const NetcdfVariable& variable) {
  for (const std::string& text : {variable.attribute("coordinates"), file.attribute("coordinates")})
    for (const std::string& name : words_between_blanks(text)) {
      const NetcdfVariable* coordinate = file.find(name);
      if (coordinate == nullptr || coordinate == &variable || !is_scalar(*coordinate)) continue;
      const AxisRole role = role_of(*coordinate);
      if (role == AxisRole::depth || role == AxisRole::other_level) return coordinate;
    }
  const NetcdfVariable* only = nullptr;
  for (const NetcdfVariable& other : file.variables()) {
    if (!is_scalar(other) || !declares_a_level(other)) continue;
    if (only != nullptr) return nullptr;
    only = &other;
  }
  return only;
}

Checked<AxisNodes> projected_nodes(const NetcdfVariable& coordinate, Messages& warnings) {
  auto values = coordinate.read_all();
  if (!values) return refuse(values.error());
  const std::string unit = coordinate.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse(messages::ingest_netcdf_message<"projected-axis-without-length">(coordinate.name(), unit));
  if (unit.empty())
    warnings.push_back(
        messages::ingest_netcdf_message<"axis-without-unit">("projected coordinate", coordinate.name()));
  for (double& value : *values) value *= *factor;
  return monotonic_nodes(coordinate.name(), std::move(*values));
}

}  // namespace floeplan::ingest
