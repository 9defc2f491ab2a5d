#include "storage/ingest/readers/tides/tide_layout.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using ocean::TideQuantity;

constexpr std::uint64_t max_tide_nodes = 25'000'000;
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::string suffix_of(TideQuantity quantity) {
  switch (quantity) {
    case TideQuantity::elevation: return "z";
    case TideQuantity::east: return "u";
    case TideQuantity::north: return "v";
  }
  return "z";
}

std::vector<std::string> split(const std::string& text, std::string_view separators) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(separators, begin)) != std::string::npos) {
    const std::size_t end = text.find_first_of(separators, begin);
    parts.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

const NetcdfVariable* find_any(const NetcdfFile& file, const std::vector<std::string>& lower_names) {
  for (const std::string& name : lower_names)
    for (const NetcdfVariable& variable : file.variables())
      if (variable.is_numeric() && lower(variable.name()) == name) return &variable;
  return nullptr;
}

/// The values along one dimension of the field, and the index of the dimension.
struct FieldAxis {
  std::size_t dimension{};
  std::vector<double> values;
};

/// An axis from a list of coordinates, or from a table in which every line holds the same values.
std::optional<FieldAxis> axis_along(const NetcdfVariable& field, const NetcdfVariable& coordinate) {
  const auto values = coordinate.read_all();
  if (!values) return std::nullopt;
  if (coordinate.dimensions().size() == 1) {
    const auto dimension = field.dimension_named(coordinate.dimensions()[0].name);
    if (!dimension) return std::nullopt;
    return FieldAxis{*dimension, *values};
  }
  if (coordinate.dimensions().size() != 2) return std::nullopt;
  const auto slow = field.dimension_named(coordinate.dimensions()[0].name);
  const auto fast = field.dimension_named(coordinate.dimensions()[1].name);
  if (!slow || !fast) return std::nullopt;
  const auto rows = static_cast<std::size_t>(coordinate.dimensions()[0].size);
  const auto columns = static_cast<std::size_t>(coordinate.dimensions()[1].size);
  FieldAxis along_slow{*slow, {}};
  FieldAxis along_fast{*fast, {}};
  for (std::size_t i = 0; i < rows; ++i) along_slow.values.push_back((*values)[i * columns]);
  for (std::size_t j = 0; j < columns; ++j) along_fast.values.push_back((*values)[j]);
  bool is_slow = true;
  bool is_fast = true;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      is_slow = is_slow && std::abs((*values)[i * columns + j] - along_slow.values[i]) < 1e-6;
      is_fast = is_fast && std::abs((*values)[i * columns + j] - along_fast.values[j]) < 1e-6;
    }
  }
  if (is_slow == is_fast) return std::nullopt;
  return is_slow ? along_slow : along_fast;
}

/// The projection of a regional model: from a PROJ string or a grid mapping of the file, or else the stated
/// one.
std::optional<geo::GridFrame> stated_frame(const NetcdfFile& file, const NetcdfVariable& field,
                                           const std::optional<std::string>& stated_crs) {
  OGRSpatialReference crs;
  if (const auto own = field.crs()) return grid_frame_of(*own);
  for (const NetcdfVariable& variable : file.variables()) {
    std::string proj = variable.attribute("spatial_proj4");
    if (proj.empty()) continue;
    // Metres, because the axes are converted to metres by their own unit.
    if (const std::size_t at = proj.find("+units=km"); at != std::string::npos)
      proj.replace(at, 9, "+units=m");
    if (crs.SetFromUserInput(proj.c_str()) == OGRERR_NONE) return grid_frame_of(crs);
  }
  if (stated_crs && crs.SetFromUserInput(stated_crs->c_str()) == OGRERR_NONE) return grid_frame_of(crs);
  return std::nullopt;
}

Checked<AxisNodes> metres_along(const NetcdfVariable& coordinate, std::vector<double> values) {
  const std::string unit = coordinate.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse(messages::ingest_tide_message<"tide-axis-without-length">(coordinate.name(), unit));
  for (double& value : values) value *= *factor;
  return monotonic_nodes(coordinate.name(), std::move(values));
}

messages::Message no_axes(const TideVariables& tide) {
  return messages::ingest_tide_message<"tide-without-axes">(tide.first->name());
}

std::optional<std::size_t> other_dimension(const NetcdfVariable& field, std::size_t x, std::size_t y) {
  for (std::size_t i = 0; i < field.dimensions().size(); ++i)
    if (i != x && i != y) return i;
  return std::nullopt;
}

/// Whether two grids are equal within the rounding of single precision, 3e-5 degrees near 360.
bool are_same_nodes(const ocean::HorizontalGrid& a, const ocean::HorizontalGrid& b) {
  const auto alike = [](const ocean::Axis& one, const ocean::Axis& other) {
    const double tolerance = 1e-3 * one.mean_step();
    return std::ranges::equal(one.nodes(), other.nodes(),
                              [&](double x, double y) { return std::abs(x - y) <= tolerance; });
  };
  return geo::frame_text(a.frame()) == geo::frame_text(b.frame()) && alike(a.x(), b.x()) &&
         alike(a.y(), b.y());
}

Checked<std::vector<double>> read_tide_plane(const NetcdfVariable& variable, const TideLayout& layout,
                                             std::size_t line) {
  const auto& dimensions = variable.dimensions();
  std::vector<std::uint64_t> start(dimensions.size(), 0);
  std::vector<std::size_t> count(dimensions.size(), 1);
  const std::size_t x = layout.x_dimension;
  const std::size_t y = layout.y_dimension;
  if (layout.line_dimension) start[*layout.line_dimension] = line;
  count[x] = static_cast<std::size_t>(dimensions[x].size);
  count[y] = static_cast<std::size_t>(dimensions[y].size);
  const auto packed = variable.read_packed(start, count);
  if (!packed) return refuse(packed.error());

  const std::size_t step_x = x > y ? 1 : count[y];
  const std::size_t step_y = x > y ? count[x] : 1;
  std::vector<double> values;
  values.reserve(layout.grid.size());
  for (const std::size_t iy : layout.y.source)
    for (const std::size_t ix : layout.x.source)
      values.push_back(variable.unpacked((*packed)[iy * step_y + ix * step_x]));
  return values;
}

}  // namespace

Checked<TideLayout> tide_layout_of(const NetcdfFile& file, const TideVariables& tide,
                                   const std::optional<std::string>& stated_crs) {
  const NetcdfVariable& field = *tide.first;
  std::uint64_t size = 1;
  for (const NetcdfDimension& dimension : field.dimensions()) {
    if (dimension.size == 0 || dimension.size > 1'000'000)
      return refuse(messages::ingest_tide_message<"tide-dimension-too-long">(dimension.name, dimension.size));
    size *= dimension.size;
    if (size > 400 * max_tide_nodes)
      return refuse(messages::ingest_tide_message<"tide-too-large">(max_tide_nodes));
  }
  const std::string suffix = suffix_of(tide.quantity);
  const auto axis = [&](const std::vector<std::string>& names)
      -> std::pair<const NetcdfVariable*, std::optional<FieldAxis>> {
    const NetcdfVariable* coordinate = find_any(file, names);
    if (coordinate == nullptr) return {nullptr, std::nullopt};
    return {coordinate, axis_along(field, *coordinate)};
  };
  auto [lon, along_lon] = axis({"lon_" + suffix, "longitude_" + suffix, "lon", "longitude"});
  auto [lat, along_lat] = axis({"lat_" + suffix, "latitude_" + suffix, "lat", "latitude"});
  TideLayout layout{0, 0, {}, {}, {}, {geo::GeographicFrame{}, ocean::Axis{{0.0}}, ocean::Axis{{0.0}}}};
  Checked<AxisNodes> x = refuse(no_axes(tide));
  Checked<AxisNodes> y = x;
  std::optional<geo::GridFrame> frame = geo::GeographicFrame{};
  if (along_lon && along_lat) {
    layout.x_dimension = along_lon->dimension;
    layout.y_dimension = along_lat->dimension;
    x = longitude_nodes(lon->name(), std::move(along_lon->values));
    y = latitude_nodes(lat->name(), std::move(along_lat->values));
  } else {
    auto [east, along_x] = axis({"x"});
    auto [north, along_y] = axis({"y"});
    if (!along_x || !along_y) return refuse(no_axes(tide));
    layout.x_dimension = along_x->dimension;
    layout.y_dimension = along_y->dimension;
    x = metres_along(*east, std::move(along_x->values));
    y = metres_along(*north, std::move(along_y->values));
    frame = stated_frame(file, field, stated_crs);
    if (!frame) return refuse(messages::ingest_tide_message<"tide-projection-unknown">(field.name()));
  }
  if (!x) return refuse(x.error());
  if (!y) return refuse(y.error());
  if (layout.x_dimension == layout.y_dimension || field.dimensions().size() > 3) return refuse(no_axes(tide));
  if (x->nodes.size() * y->nodes.size() > max_tide_nodes)
    return refuse(messages::ingest_tide_message<"tide-too-large">(max_tide_nodes));
  layout.line_dimension = other_dimension(field, layout.x_dimension, layout.y_dimension);
  layout.grid = ocean::HorizontalGrid{*frame, ocean::Axis{x->nodes}, ocean::Axis{y->nodes}};
  if (!std::holds_alternative<geo::GeographicFrame>(*frame) && !lies_in_projection(layout.grid))
    return refuse(messages::ingest_tide_message<"tide-projection-unknown">(field.name()));
  layout.x = std::move(*x);
  layout.y = std::move(*y);
  return layout;
}

std::optional<tide::Constituent> constituent_named_in(const std::string& file_stem) {
  for (const std::string& part : split(file_stem, "_.- "))
    if (const auto constituent = tide::find_constituent(part)) return constituent;
  return std::nullopt;
}

Checked<std::vector<std::string>> tide_names(const NetcdfFile& file, const std::string& file_stem,
                                             std::size_t wanted) {
  for (const NetcdfVariable& variable : file.variables()) {
    const std::string order = variable.attribute("constituent_order");
    if (!order.empty() && split(order, " ,").size() == wanted) return split(order, " ,");
  }
  for (const char* name : {"con", "constituent", "constituents", "ntides"})
    if (const NetcdfVariable* variable = file.find(name))
      if (auto texts = variable->texts(); texts.size() == wanted) return texts;
  if (wanted == 1)
    if (const auto named = constituent_named_in(file_stem))
      return std::vector{tide::constituent_name(*named)};
  return refuse(wanted == 1 ? messages::ingest_tide_message<"constituent-not-named">()
                            : messages::ingest_tide_message<"constituents-not-named">(wanted));
}

Checked<std::vector<std::complex<double>>> read_tide_field(const TideVariables& tide,
                                                           const TideLayout& layout, std::size_t line) {
  const auto first = read_tide_plane(*tide.first, layout, line);
  if (!first) return refuse(first.error());
  const auto second = read_tide_plane(*tide.second, layout, line);
  if (!second) return refuse(second.error());
  std::vector<std::complex<double>> field;
  field.reserve(first->size());
  for (std::size_t i = 0; i < first->size(); ++i) {
    const double a = (*first)[i];
    const double b = (*second)[i];
    if (std::isnan(a) || std::isnan(b) || (a == 0.0 && b == 0.0))
      field.emplace_back(no_value, no_value);
    else
      field.push_back(tide.amplitude_and_phase ? tide::harmonic_value(a, b) : std::complex{a, b});
  }
  return field;
}

Checked<std::vector<double>> read_tide_depths(const NetcdfFiles& files, const TideVariables& tide,
                                              const TideLayout& layout,
                                              const std::optional<std::string>& stated_crs) {
  for (const auto& file : files) {
    const NetcdfVariable* depth = find_any(*file, {"h" + suffix_of(tide.quantity), "wct"});
    if (depth == nullptr || depth->dimensions().size() != 2) continue;
    const auto own = tide_layout_of(*file, {tide.quantity, depth, depth}, stated_crs);
    if (!own || !are_same_nodes(own->grid, layout.grid)) continue;
    auto depths = read_tide_plane(*depth, *own, 0);
    if (!depths) return refuse(depths.error());
    for (double& value : *depths)
      if (!(value > 0.0)) value = no_value;
    return depths;
  }
  return std::vector<double>{};
}

}  // namespace floeplan::ingest
