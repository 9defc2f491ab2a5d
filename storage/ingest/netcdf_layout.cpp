#include "storage/ingest/netcdf_layout.hpp"

#include <algorithm>
#include <cmath>

#include "storage/ingest/cf_time.hpp"
#include "storage/ingest/cf_units.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t max_axis_nodes = 1'000'000;
constexpr std::uint64_t max_slice_nodes = 250'000'000;  // 1 GB as float32

bool runs_along(const NetcdfVariable& variable, const NetcdfDimension& dimension) {
  return variable.is_numeric() && variable.dimensions().size() == 1 &&
         variable.dimensions().front().name == dimension.name;
}

/// The coordinate variable of a dimension: one-dimensional and of the dimension's own name; where nothing has that
/// name, the only variable along it whose standard name makes it a coordinate ("xgrid" along "x"). GDAL's own
/// indexing variable is not asked: it may be a two-dimensional table or belong to the other axis.
const NetcdfVariable* coordinate_of(const NetcdfFile& file, const NetcdfDimension& dimension) {
  if (const NetcdfVariable* named = file.find(dimension.name))
    return runs_along(*named, dimension) ? named : nullptr;
  const NetcdfVariable* found = nullptr;
  for (const NetcdfVariable& variable : file.variables()) {
    if (!runs_along(variable, dimension) || variable.attribute("standard_name").empty() ||
        role_of(variable) == AxisRole::unknown)
      continue;
    if (found != nullptr) return nullptr;
    found = &variable;
  }
  return found;
}

bool has_table_of_positions(const NetcdfFile& file) {
  return std::any_of(file.variables().begin(), file.variables().end(), [](const NetcdfVariable& variable) {
    if (variable.dimensions().size() < 2) return false;
    const AxisRole role = role_of(variable);
    return role == AxisRole::longitude ||
           contains_any(lower(variable.name()), {"ulon", "tlon", "glam", "geolon"});
  });
}

Checked<AxisNodes> depth_nodes(const NetcdfVariable& coordinate, std::vector<std::string>& warnings) {
  auto values = coordinate.read_all();
  if (!values) return refuse(values.error());
  const std::string unit = coordinate.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse("the depth axis \"" + coordinate.name() + "\" has the unit \"" + unit +
                  "\", which is no length; levels cannot be placed in the water; ask for levels in metres");
  if (unit.empty())
    warnings.push_back("the depth axis \"" + coordinate.name() + "\" states no unit; taken as metres");

  const std::string positive = lower(coordinate.attribute("positive"));
  const bool all_below_zero =
      std::all_of(values->begin(), values->end(), [](double v) { return v <= 0.0; }) &&
      std::any_of(values->begin(), values->end(), [](double v) { return v < 0.0; });
  const bool up = positive == "up" || (positive != "down" && all_below_zero);
  for (double& value : *values) value *= up ? -*factor : *factor;
  for (double& value : *values)
    if (value == 0.0) value = 0.0;  // -0 becomes 0

  auto nodes = monotonic_nodes(coordinate.name(), std::move(*values));
  if (nodes && (nodes->nodes.front() < -10.0 || nodes->nodes.back() > 12000.0))
    return refuse("the depth axis \"" + coordinate.name() + "\" runs from " + number(nodes->nodes.front()) +
                  " to " + number(nodes->nodes.back()) +
                  " m below the surface; no ocean does; its unit or direction is wrong");
  return nodes;
}

Checked<AxisNodes> time_nodes(const NetcdfVariable& coordinate, std::vector<std::string>& warnings) {
  const std::string unit = coordinate.attribute("units");
  if (unit.empty())
    return refuse("the time axis \"" + coordinate.name() +
                  "\" has no units; without a starting date the times are unknown; ask the producer for a "
                  "file with units like \"hours since 2000-01-01\"");
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
  if (decoder->is_model_calendar())
    warnings.push_back("the times are in a model's own calendar (\"" + coordinate.attribute("calendar") +
                       "\"); the dates were kept, but tides and weather of those days are not the real ones");
  return sorted_nodes(coordinate.name(), std::move(seconds));
}

/// A time that the file states once for all its data.
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

Checked<AxisNodes> projected_nodes(const NetcdfVariable& coordinate, std::vector<std::string>& warnings) {
  auto values = coordinate.read_all();
  if (!values) return refuse(values.error());
  const std::string unit = coordinate.attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse("the projected coordinate \"" + coordinate.name() + "\" has the unit \"" + unit +
                  "\", which is no length; the grid cannot be placed; ask for coordinates in metres");
  if (unit.empty())
    warnings.push_back("the projected coordinate \"" + coordinate.name() +
                       "\" states no unit; taken as metres");
  for (double& value : *values) value *= *factor;
  return monotonic_nodes(coordinate.name(), std::move(*values));
}

struct RoleOfDimension {
  AxisRole role{AxisRole::unknown};
  const NetcdfVariable* coordinate{nullptr};
};

/// Reads the coordinates of one dimension into the layout.
Checked<bool> add_dimension(NetcdfLayout& layout, std::size_t index, const RoleOfDimension& found) {
  const NetcdfVariable& coordinate = *found.coordinate;
  Checked<AxisNodes> nodes = AxisNodes{};
  switch (found.role) {
    case AxisRole::longitude:
    case AxisRole::latitude: {
      auto values = coordinate.read_all();
      if (!values) return refuse(values.error());
      nodes = found.role == AxisRole::longitude ? longitude_nodes(coordinate.name(), std::move(*values))
                                                : latitude_nodes(coordinate.name(), std::move(*values));
      break;
    }
    case AxisRole::depth: nodes = depth_nodes(coordinate, layout.warnings); break;
    case AxisRole::time: nodes = time_nodes(coordinate, layout.warnings); break;
    case AxisRole::projected_x:
    case AxisRole::projected_y: nodes = projected_nodes(coordinate, layout.warnings); break;
    case AxisRole::model_level:
    case AxisRole::unknown: return true;
  }
  if (!nodes) return refuse(nodes.error());

  if (found.role == AxisRole::depth) {
    layout.depth_dimension = index;
    layout.depths_m = std::move(*nodes);
  } else if (found.role == AxisRole::time) {
    layout.time_dimension = index;
    layout.times_s = std::move(*nodes);
  } else if (found.role == AxisRole::longitude || found.role == AxisRole::projected_x) {
    layout.x_dimension = index;
    layout.x = std::move(*nodes);
  } else {
    layout.y_dimension = index;
    layout.y = std::move(*nodes);
  }
  return true;
}

}  // namespace

std::optional<std::string> unsupported_grid(const NetcdfFile& file, const NetcdfVariable& variable) {
  const bool mesh =
      std::any_of(file.variables().begin(), file.variables().end(),
                  [](const NetcdfVariable& other) { return other.attribute("cf_role") == "mesh_topology"; });
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    const std::string name = lower(dimension.name);
    if (mesh || name == "nele" || name == "node" || name == "ncells" || name.starts_with("nmesh2"))
      return "the file is the output of an unstructured model (a mesh of triangles or cells, as FVCOM, SELFE "
             "and UGRID write it); this layout is not yet supported; interpolate it to a regular "
             "longitude-latitude grid first";
  }
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    const std::string name = lower(dimension.name);
    if (name.starts_with("xi_") || name.starts_with("eta_") || name.starts_with("s_rho"))
      return "the file is the output of a ROMS or CROCO model (a bent, staggered grid with levels that "
             "follow the sea bed); this layout is not yet supported; interpolate it to longitude, latitude "
             "and depth first";
  }
  const bool located = std::all_of(variable.dimensions().begin(), variable.dimensions().end(),
                                   [&](const NetcdfDimension& dimension) {
                                     return dimension.size == 1 || coordinate_of(file, dimension) != nullptr;
                                   });
  if (!located && has_table_of_positions(file))
    return "the variable \"" + variable.name() +
           "\" lies on a curvilinear (bent) grid whose longitudes and latitudes are two-dimensional tables, "
           "as NEMO, POP and other global models use; this layout is not yet supported; interpolate it to a "
           "regular longitude-latitude grid first";
  return std::nullopt;
}

Checked<NetcdfLayout> layout_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  if (const auto unsupported = unsupported_grid(file, variable)) return refuse(*unsupported);

  NetcdfLayout layout;
  std::vector<RoleOfDimension> roles;
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    if (dimension.size == 0)
      return refuse("the dimension \"" + dimension.name +
                    "\" is empty; the file holds no data; ask for another");
    if (dimension.size > max_axis_nodes)
      return refuse("the dimension \"" + dimension.name + "\" has " + std::to_string(dimension.size) +
                    " values, more than this program accepts (" + std::to_string(max_axis_nodes) +
                    "); the file is damaged, or you should cut out your area first");
    const NetcdfVariable* coordinate = coordinate_of(file, dimension);
    roles.push_back({coordinate == nullptr ? AxisRole::unknown : role_of(*coordinate), coordinate});
    if (roles.back().role == AxisRole::model_level)
      return refuse("the levels \"" + dimension.name +
                    "\" follow the sea bed (a sigma or s coordinate); this layout is not yet supported; "
                    "interpolate the data to depths in metres first");
    if (roles.back().role == AxisRole::unknown && dimension.size > 1)
      return refuse("the dimension \"" + dimension.name + "\" of \"" + variable.name() +
                    "\" has no coordinates that say what it is; the data cannot be placed; ask for a file "
                    "with longitude, latitude, depth and time coordinates");
  }

  const auto has = [&](AxisRole role) {
    return std::count_if(roles.begin(), roles.end(),
                         [&](const RoleOfDimension& r) { return r.role == role; });
  };
  const bool geographic = has(AxisRole::longitude) == 1 && has(AxisRole::latitude) == 1;
  layout.projected = has(AxisRole::projected_x) == 1 && has(AxisRole::projected_y) == 1;
  if (geographic == layout.projected || has(AxisRole::depth) > 1 || has(AxisRole::time) > 1)
    return refuse("the variable \"" + variable.name() +
                  "\" does not lie on one longitude and one latitude axis; the data cannot be placed on the "
                  "Earth; ask for a regular longitude-latitude grid");

  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i].role == AxisRole::unknown) continue;
    const auto added = add_dimension(layout, i, roles[i]);
    if (!added) return refuse(added.error());
  }
  if (layout.x.nodes.size() * layout.y.nodes.size() > max_slice_nodes)
    return refuse("the grid has " + std::to_string(layout.x.nodes.size()) + " x " +
                  std::to_string(layout.y.nodes.size()) + " nodes, more than this program accepts (" +
                  std::to_string(max_slice_nodes) + "); cut out your area first");

  if (!layout.times_s) {
    if (const NetcdfVariable* time = scalar_time(file)) {
      auto nodes = time_nodes(*time, layout.warnings);
      if (!nodes) return refuse(nodes.error());
      layout.times_s = std::move(*nodes);
    }
  }
  return layout;
}

Checked<std::vector<double>> read_slice(const NetcdfVariable& variable, const NetcdfLayout& layout,
                                        std::size_t time_index, std::size_t depth_index) {
  const auto& dimensions = variable.dimensions();
  std::vector<std::uint64_t> start(dimensions.size(), 0);
  std::vector<std::size_t> count(dimensions.size(), 1);
  if (layout.time_dimension) start[*layout.time_dimension] = layout.times_s->source[time_index];
  if (layout.depth_dimension) start[*layout.depth_dimension] = layout.depths_m->source[depth_index];
  count[layout.x_dimension] = static_cast<std::size_t>(dimensions[layout.x_dimension].size);
  count[layout.y_dimension] = static_cast<std::size_t>(dimensions[layout.y_dimension].size);

  const auto packed = variable.read_packed(start, count);
  if (!packed) return refuse(packed.error());

  const bool x_fastest = layout.x_dimension > layout.y_dimension;
  const std::size_t step_x = x_fastest ? 1 : count[layout.y_dimension];
  const std::size_t step_y = x_fastest ? count[layout.x_dimension] : 1;
  std::vector<double> values;
  values.reserve(layout.x.nodes.size() * layout.y.nodes.size());
  for (const std::size_t y : layout.y.source)
    for (const std::size_t x : layout.x.source)
      values.push_back(variable.unpacked((*packed)[y * step_y + x * step_x]));
  return values;
}

}  // namespace floeplan::ingest
