#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/formats/netcdf/variable_level.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"
#include "storage/ingest/readers/currents/velocity_input.hpp"

namespace floeplan::ingest {
namespace {

/// The index of the level at 10 m. Heights count upwards, so they are negative depths.
Checked<std::size_t> level_at_10_m(const SourceShape& shape) {
  if (!shape.depths_m) return std::size_t{0};
  const auto level = std::ranges::find_if(
      *shape.depths_m, [](double depth_m) { return is_height_of_wind(std::abs(depth_m)); });
  if (level != shape.depths_m->end()) return static_cast<std::size_t>(level - shape.depths_m->begin());
  return refuse(
      messages::ingest_current_message<"wind-at-other-height">(number(std::abs(shape.depths_m->back()))));
}

/// Whether a name or long name states 10 m. By convention uas, near-surface wind, is at 10 m.
bool names_ten_metres(const NetcdfVariable& variable) {
  const auto level = wind_level_in_words(variable);
  return (level && level->at_10_m) || lower(variable.name()) == "uas";
}

/// Whether a coordinate counts the model's own levels or follows the ground. Only its standard name decides:
/// files list "sigma" beside winds at 10 m as the level of other variables.
/// Source   CF conventions 1.8, appendix D: the vertical coordinates of the air
bool is_model_level(const NetcdfVariable& coordinate) {
  const std::string standard_name = lower(coordinate.attribute("standard_name"));
  return standard_name == "model_level_number" ||
         (standard_name.starts_with("atmosphere_") && standard_name.ends_with("_coordinate"));
}

/// The coordinate of model levels on which a wind lies; null if there is none.
const NetcdfVariable* model_level_of(const NetcdfFile& file, const NetcdfVariable& wind) {
  for (const NetcdfDimension& dimension : wind.dimensions()) {
    const NetcdfVariable* coordinate = coordinate_of(file, dimension);
    if (coordinate != nullptr && is_model_level(*coordinate)) return coordinate;
  }
  for (const std::string& name : words_between_blanks(wind.attribute("coordinates"))) {
    const NetcdfVariable* coordinate = file.find(name);
    if (coordinate != nullptr && is_model_level(*coordinate)) return coordinate;
  }
  return nullptr;
}

Checked<CurrentInput> open_wind(const std::shared_ptr<const NetcdfFile>& file,
                                const std::optional<std::string>& stated_crs) {
  auto pair = find_velocity_pair({file}, Moving::air);
  if (!pair) return refuse(pair.error());
  if (const NetcdfVariable* level = model_level_of(*file, *pair->first))
    return refuse(messages::ingest_current_message<"wind-on-model-levels">(
        pair->first->name(), pair->second->name(), level->name()));
  auto input = velocity_input({file}, *pair, stated_crs);
  if (!input) return refuse(input.error());
  const SourceShape& shape = input->source->shape();
  const auto level = level_at_10_m(shape);
  if (!level) return refuse(level.error());
  if (!shape.depths_m && !names_ten_metres(*pair->first))
    input->warnings.push_back(
        messages::ingest_current_message<"wind-without-height">(pair->first->name(), pair->second->name()));
  keep_level(*input, *level, std::nullopt);
  return input;
}

}  // namespace

bool holds_wind(const NetcdfFile& file) { return holds_velocity(file, Moving::air); }

Checked<PreparedDataset> read_wind(const std::shared_ptr<const NetcdfFile>& file,
                                   const std::optional<std::string>& stated_crs,
                                   const core::ProgressCallback& progress) {
  auto input = open_wind(file, stated_crs);
  if (!input) return refuse(input.error());
  return prepare_currents(std::move(*input), progress);
}

bool wind_is_readable(const std::shared_ptr<const NetcdfFile>& file) {
  return open_wind(file, std::nullopt).has_value();
}

}  // namespace floeplan::ingest
