#include "storage/ingest/wind_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "storage/ingest/text.hpp"
#include "storage/ingest/velocity_input.hpp"

namespace floeplan::ingest {
namespace {

constexpr double wind_height_m = 10.0;
constexpr double same_height_m = 0.5;

using NamePair = std::pair<std::string_view, std::string_view>;

/// At 10 m by their names, or at the height of their levels.
constexpr std::array known_pairs{
    NamePair{"u10", "v10"},
    NamePair{"10u", "10v"},
    NamePair{"u10m", "v10m"},
    NamePair{"uas", "vas"},
    NamePair{"eastward_wind", "northward_wind"},
    NamePair{"u-component_of_wind_height_above_ground", "v-component_of_wind_height_above_ground"},
    NamePair{"ugrd10m", "vgrd10m"},
    NamePair{"ugrd_10maboveground", "vgrd_10maboveground"},
    NamePair{"x_wind_10m", "y_wind_10m"},
    NamePair{"uwnd", "vwnd"},
    NamePair{"u", "v"},
};

std::string description(const NetcdfVariable& variable) {
  return lower(variable.attribute("standard_name") + " " + variable.attribute("long_name"));
}

/// Components called u and v are wind only where they say so themselves.
bool may_be_wind(const NetcdfVariable& variable) {
  const std::string text = description(variable);
  if (!variable.is_numeric() ||
      contains_any(text, {"gust", "stress", "shear", "sea_water", "anomal", "100 m"}))
    return false;
  return variable.name().size() > 1 || contains_any(text, {"wind"});
}

const NetcdfVariable* find_named(const NetcdfFile& file, std::string_view name) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.name()) == name && may_be_wind(variable)) return &variable;
  return nullptr;
}

const NetcdfVariable* find_standard(const NetcdfFile& file, std::string_view name) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.attribute("standard_name")) == name && may_be_wind(variable)) return &variable;
  return nullptr;
}

/// A whole pair if there is any, else a component, else nothing.
VelocityPair find_either(const NetcdfFile& file) {
  VelocityPair found;
  found.first_file = found.second_file = &file;
  const auto take = [&](const NetcdfVariable* first, const NetcdfVariable* second) {
    const bool whole = first != nullptr && second != nullptr;
    if (!whole && (found.first != nullptr || found.second != nullptr)) return false;
    found.first = first;
    found.second = second;
    return whole;
  };
  for (const auto& [first, second] : known_pairs)
    if (take(find_named(file, first), find_named(file, second))) return found;
  if (take(find_standard(file, "eastward_wind"), find_standard(file, "northward_wind"))) return found;
  take(find_standard(file, "x_wind"), find_standard(file, "y_wind"));
  return found;
}

/// Global and regional models name the components of a regular grid in longitude and latitude u and v; x and y wind
/// are along the axes of a projection by their standard names.
VelocityAxes axes_of(const NetcdfVariable& variable) {
  const std::string words = lower(variable.name()) + " " + description(variable);
  if (contains_any(words, {"x_wind", "y_wind", "grid-x", "grid-y"})) return VelocityAxes::grid;
  if (contains_any(words, {"eastward", "northward"})) return VelocityAxes::east_north;
  return VelocityAxes::unstated;
}

Checked<VelocityPair> find_pair(const NetcdfFile& file) {
  VelocityPair pair = find_either(file);
  if (pair.first == nullptr && pair.second == nullptr)
    return refuse(
        "the file holds no wind near the sea; there is nothing to store; give a file with, for example, the "
        "variables u10 and v10");
  if (pair.first == nullptr || pair.second == nullptr) {
    const NetcdfVariable& alone = pair.first != nullptr ? *pair.first : *pair.second;
    return refuse("the file holds only one component of the wind (\"" + alone.name() +
                  "\"); merge both components into one file");
  }
  pair.axes = axes_of(*pair.first);
  if (axes_of(*pair.second) != pair.axes)
    return refuse("the components \"" + pair.first->name() + "\" and \"" + pair.second->name() +
                  "\" are described differently: one along the model's grid, the other not; ask the producer "
                  "for a file that describes both");
  return pair;
}

/// One level of a source, as if it were all there is.
class OneLevel : public VelocitySource {
 public:
  OneLevel(std::shared_ptr<const VelocitySource> source, std::size_t level)
      : source_{std::move(source)}, level_{level}, shape_{source_->shape()} {
    shape_.levels = 1;
    shape_.depths_m.reset();
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return source_->place(point); }
  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t /*level*/) const override {
    return source_->read(time, level_);
  }
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const override {
    return source_->level_depths(time, level);
  }

 private:
  std::shared_ptr<const VelocitySource> source_;
  std::size_t level_;
  SourceShape shape_;
};

/// The level at 10 m: heights count upwards, so that they are negative depths.
Checked<std::size_t> level_at_10_m(const SourceShape& shape) {
  if (!shape.depths_m) return std::size_t{0};
  const auto level = std::ranges::find_if(*shape.depths_m, [](double depth_m) {
    return std::abs(std::abs(depth_m) - wind_height_m) <= same_height_m;
  });
  if (level != shape.depths_m->end()) return static_cast<std::size_t>(level - shape.depths_m->begin());
  return refuse(
      "the wind is given at " + number(std::abs(shape.depths_m->back())) +
      " m, but not at 10 m above the ground; higher up it is stronger than what moves an iceberg; ask "
      "for the wind at 10 m");
}

Checked<CurrentInput> open_wind(const std::shared_ptr<const NetcdfFile>& file,
                                const std::optional<std::string>& stated_crs) {
  auto pair = find_pair(*file);
  if (!pair) return refuse(pair.error());
  auto input = velocity_input({file}, *pair, stated_crs);
  if (!input) return refuse(input.error());
  input->what = Moving::air;
  const auto level = level_at_10_m(input->source->shape());
  if (!level) return refuse(level.error());
  input->source = std::make_shared<const OneLevel>(std::move(input->source), *level);
  return input;
}

}  // namespace

bool holds_wind(const NetcdfFile& file) {
  const VelocityPair pair = find_either(file);
  return pair.first != nullptr || pair.second != nullptr;
}

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
