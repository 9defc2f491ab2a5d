#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"

#include <algorithm>
#include <span>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/formats/netcdf/mean_times.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/notation/cf_time.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t max_axis_nodes = 1'000'000;
constexpr std::uint64_t max_mesh_points = 10'000'000;     // of a mesh, along one dimension
constexpr std::uint64_t max_slice_nodes = 4'000'000'000;  // the grid of GEBCO has 3.7e9

bool has_table_of_positions(const NetcdfFile& file) {
  return std::any_of(file.variables().begin(), file.variables().end(), [](const NetcdfVariable& variable) {
    if (variable.dimensions().size() < 2) return false;
    const AxisRole role = role_of(variable);
    return role == AxisRole::longitude ||
           contains_any(lower(variable.name()), {"ulon", "tlon", "glam", "geolon"});
  });
}

struct RoleOfDimension {
  AxisRole role{AxisRole::unknown};
  const NetcdfVariable* coordinate{nullptr};
};

/// Reads the coordinates of one dimension into the layout.
Checked<bool> add_dimension(NetcdfLayout& layout, std::size_t index, const RoleOfDimension& found) {
  if (found.coordinate == nullptr) return true;
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
    case AxisRole::other_level:
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

std::optional<messages::Message> fault_of_size(const NetcdfDimension& dimension, bool of_points) {
  if (dimension.size == 0) return messages::ingest_netcdf_message<"dimension-empty">(dimension.name);
  const std::uint64_t most = of_points ? max_mesh_points : max_axis_nodes;
  if (dimension.size > most)
    return messages::ingest_netcdf_message<"dimension-too-long">(dimension.name, dimension.size, most);
  return std::nullopt;
}

/// The group that holds the coordinates of a dimension, if the group in use does not see them; otherwise
/// empty.
std::optional<std::string> group_with_coordinates(const NetcdfFile& file, const std::string& dimension) {
  for (const std::string& group : file.groups())
    if (file.only(group).find(dimension) != nullptr) return group;
  return std::nullopt;
}

messages::Message unknown_dimension(const NetcdfFile& file, const std::string& dimension,
                                    const std::string& variable) {
  const std::string name = lower(dimension);
  const auto is_any = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
  };
  if (is_any({"expver"}))
    return messages::ingest_netcdf_message<"final-and-preliminary">(variable, dimension);
  if (is_any({"number", "member", "members", "ens", "ensemble", "ensemble_member", "realization"}))
    return messages::ingest_netcdf_message<"ensemble-members">(variable, dimension);
  if (is_any({"step", "lead", "leadtime", "lead_time", "forecast_period", "forecast_time"}))
    return messages::ingest_netcdf_message<"several-forecasts">(variable, dimension);
  if (const auto group = group_with_coordinates(file, dimension))
    return messages::ingest_netcdf_message<"coordinates-of-another-group">(dimension, variable, *group);
  if (const NetcdfVariable* axis = file.find(dimension)) {
    const std::string unit = axis->attribute("units");
    if (CfTime::parse(unit + " since 2000-01-01", ""))
      return messages::ingest_netcdf_message<"times-without-start">(dimension, variable, unit);
  }
  return messages::ingest_netcdf_message<"dimension-without-coordinates">(dimension, variable);
}

/// Role of a dimension without a coordinate variable. Terrain-following levels often have only tables of
/// heights.
AxisRole role_of_dimension(const NetcdfFile& file, const NetcdfDimension& dimension) {
  const std::string name = lower(dimension.name);
  if (heights_along(file, dimension) != nullptr) return AxisRole::model_level;
  return name.starts_with("s_rho") || name.starts_with("siglay") || name.starts_with("sigma")
             ? AxisRole::model_level
             : AxisRole::unknown;
}

AxisNodes indices(std::uint64_t count) {
  AxisNodes axis;
  for (std::size_t i = 0; i < count; ++i) {
    axis.nodes.push_back(static_cast<double>(i));
    axis.source.push_back(i);
  }
  return axis;
}

/// A scalar level beside the variable counts as a depth dimension with one level.
Checked<bool> add_level_beside(const NetcdfFile& file, const NetcdfVariable& variable, NetcdfLayout& layout) {
  const NetcdfVariable* level = layout.depth_dimension ? nullptr : level_beside(file, variable);
  if (level == nullptr) return true;
  if (cannot_be_placed(*level)) return refuse(not_in_metres(*level, variable.name()));
  if (role_of(*level) != AxisRole::depth) return true;
  auto nodes = depth_nodes(*level, layout.warnings);
  if (!nodes) return refuse(nodes.error());
  layout.depths_m = std::move(*nodes);
  return true;
}

/// Checks the size of a slice; adds the time and the level that the file states once for all data.
Checked<NetcdfLayout> finished(const NetcdfFile& file, const NetcdfVariable& variable, NetcdfLayout layout) {
  if (layout.x.nodes.size() * layout.y.nodes.size() > max_slice_nodes)
    return refuse(messages::ingest_netcdf_message<"too-many-nodes">("the grid", layout.x.nodes.size(),
                                                                    layout.y.nodes.size(), max_slice_nodes));

  const NetcdfVariable* time = layout.time_dimension
                                   ? coordinate_of(file, variable.dimensions()[*layout.time_dimension])
                                   : scalar_time(file);
  if (!layout.times_s && time != nullptr) {
    auto nodes = time_nodes(*time, layout.warnings);
    if (!nodes) return refuse(nodes.error());
    layout.times_s = std::move(*nodes);
  }
  if (layout.times_s && time != nullptr) {
    auto nodes = times_of_means(file, variable, *time, std::move(*layout.times_s), layout.warnings);
    if (!nodes) return refuse(nodes.error());
    layout.times_s = std::move(*nodes);
  }
  if (const auto added = add_level_beside(file, variable, layout); !added) return refuse(added.error());
  return layout;
}

}  // namespace

std::optional<messages::Message> unsupported_grid(const NetcdfFile& file, const NetcdfVariable& variable) {
  const bool mesh =
      std::any_of(file.variables().begin(), file.variables().end(),
                  [](const NetcdfVariable& other) { return other.attribute("cf_role") == "mesh_topology"; });
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    const std::string name = lower(dimension.name);
    if (mesh || name == "nele" || name == "node" || name == "ncells" || name.starts_with("nmesh2"))
      return messages::ingest_netcdf_message<"layout-of-a-mesh">();
  }
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    const std::string name = lower(dimension.name);
    if (name.starts_with("xi_") || name.starts_with("eta_") || name.starts_with("s_rho"))
      return messages::ingest_netcdf_message<"layout-of-roms">();
  }
  const bool located = std::all_of(variable.dimensions().begin(), variable.dimensions().end(),
                                   [&](const NetcdfDimension& dimension) {
                                     return dimension.size == 1 || coordinate_of(file, dimension) != nullptr;
                                   });
  if (!located && has_table_of_positions(file))
    return messages::ingest_netcdf_message<"layout-of-a-bent-grid">(variable.name());
  return std::nullopt;
}

Checked<NetcdfLayout> layout_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  if (const auto unsupported = unsupported_grid(file, variable)) return refuse(*unsupported);

  NetcdfLayout layout;
  std::vector<RoleOfDimension> roles;
  for (const NetcdfDimension& dimension : variable.dimensions()) {
    if (auto fault = fault_of_size(dimension, false)) return refuse(std::move(*fault));
    const NetcdfVariable* coordinate = coordinate_of(file, dimension);
    roles.push_back({coordinate == nullptr ? AxisRole::unknown : role_of(*coordinate), coordinate});
    if (roles.back().role == AxisRole::model_level)
      return refuse(messages::ingest_netcdf_message<"levels-follow-the-bed">(dimension.name));
    if (coordinate != nullptr && cannot_be_placed(*coordinate))
      return refuse(not_in_metres(*coordinate, variable.name()));
    if (roles.back().role == AxisRole::unknown && dimension.size > 1)
      return refuse(unknown_dimension(file, dimension.name, variable.name()));
  }

  const auto has = [&](AxisRole role) {
    return std::count_if(roles.begin(), roles.end(),
                         [&](const RoleOfDimension& r) { return r.role == role; });
  };
  const bool geographic = has(AxisRole::longitude) == 1 && has(AxisRole::latitude) == 1;
  layout.projected = has(AxisRole::projected_x) == 1 && has(AxisRole::projected_y) == 1;
  if (geographic == layout.projected || has(AxisRole::depth) > 1 || has(AxisRole::time) > 1)
    return refuse(messages::ingest_netcdf_message<"without-plain-axes">(variable.name()));

  for (std::size_t i = 0; i < roles.size(); ++i) {
    const auto added = add_dimension(layout, i, roles[i]);
    if (!added) return refuse(added.error());
  }
  return finished(file, variable, std::move(layout));
}

Checked<NetcdfLayout> layout_over(const NetcdfFile& file, const NetcdfVariable& variable,
                                  std::size_t y_dimension, std::size_t x_dimension) {
  NetcdfLayout layout;
  layout.y_dimension = y_dimension;
  layout.x_dimension = x_dimension;
  const auto& dimensions = variable.dimensions();
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    if (auto fault = fault_of_size(dimensions[i], i == x_dimension || i == y_dimension))
      return refuse(*fault);
    if (i == x_dimension || i == y_dimension) continue;
    const NetcdfVariable* coordinate = coordinate_of(file, dimensions[i]);
    const AxisRole role =
        coordinate == nullptr ? role_of_dimension(file, dimensions[i]) : role_of(*coordinate);
    if (coordinate != nullptr && cannot_be_placed(*coordinate))
      return refuse(not_in_metres(*coordinate, variable.name()));
    if (role == AxisRole::model_level && layout.depth_dimension == std::nullopt) {
      layout.depth_dimension = i;
      layout.bed_levels = static_cast<std::size_t>(dimensions[i].size);
    } else if ((role == AxisRole::depth || role == AxisRole::time) && coordinate != nullptr) {
      const auto added = add_dimension(layout, i, {role, coordinate});
      if (!added) return refuse(added.error());
    } else if (dimensions[i].size > 1) {
      return refuse(unknown_dimension(file, dimensions[i].name, variable.name()));
    }
  }
  layout.x = indices(dimensions[x_dimension].size);
  layout.y = indices(x_dimension == y_dimension ? 1 : dimensions[y_dimension].size);
  return finished(file, variable, std::move(layout));
}

Checked<std::vector<double>> read_slice(const NetcdfVariable& variable, const NetcdfLayout& layout,
                                        std::size_t time_index, std::size_t depth_index) {
  return read_rows(variable, layout, time_index, depth_index, 0, layout.y.source.size());
}

Checked<std::vector<double>> read_rows(const NetcdfVariable& variable, const NetcdfLayout& layout,
                                       std::size_t time_index, std::size_t depth_index, std::size_t first_row,
                                       std::size_t rows) {
  const auto& dimensions = variable.dimensions();
  std::vector<std::uint64_t> start(dimensions.size(), 0);
  std::vector<std::size_t> count(dimensions.size(), 1);
  if (layout.time_dimension) start[*layout.time_dimension] = layout.times_s->source[time_index];
  if (layout.depth_dimension)
    start[*layout.depth_dimension] = layout.depths_m ? layout.depths_m->source[depth_index] : depth_index;
  const auto wanted = std::span{layout.y.source}.subspan(first_row, rows);
  const auto [lowest, highest] = std::ranges::minmax(wanted);
  start[layout.y_dimension] = lowest;
  count[layout.y_dimension] = highest - lowest + 1;
  count[layout.x_dimension] = static_cast<std::size_t>(dimensions[layout.x_dimension].size);

  auto packed = variable.read_packed(start, count);
  if (!packed) return refuse(packed.error());

  const bool x_fastest = layout.x_dimension >= layout.y_dimension;
  const std::size_t step_x = x_fastest ? 1 : count[layout.y_dimension];
  const std::size_t step_y = x_fastest ? count[layout.x_dimension] : 1;
  const bool whole_rows = step_x == 1 && std::ranges::is_sorted(layout.x.source) &&
                          layout.x.source.size() == count[layout.x_dimension];
  if (whole_rows && std::ranges::is_sorted(wanted) && packed->size() == layout.x.source.size() * rows) {
    variable.unpack(*packed);
    return packed;
  }
  std::vector<double> values;
  values.reserve(layout.x.nodes.size() * rows);
  for (const std::size_t y : wanted) {
    const auto row = packed->begin() + static_cast<std::ptrdiff_t>((y - lowest) * step_y);
    if (whole_rows) {
      values.insert(values.end(), row, row + static_cast<std::ptrdiff_t>(layout.x.source.size()));
      continue;
    }
    for (const std::size_t x : layout.x.source)
      values.push_back(row[static_cast<std::ptrdiff_t>(x * step_x)]);
  }
  variable.unpack(values);
  return values;
}

}  // namespace floeplan::ingest
