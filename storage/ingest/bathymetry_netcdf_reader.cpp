#include "storage/ingest/bathymetry_netcdf_reader.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>

#include "engine/geo/geodesic.hpp"
#include "storage/ingest/bathymetry_grid.hpp"
#include "storage/ingest/cf_units.hpp"
#include "storage/ingest/grid_frame_of_crs.hpp"
#include "storage/ingest/netcdf_layout.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

/// At least two dimensions, and no more than two that are longer than one.
bool is_plane(const NetcdfVariable& variable) {
  const auto& dimensions = variable.dimensions();
  const auto long_ones =
      std::count_if(dimensions.begin(), dimensions.end(), [](const auto& d) { return d.size > 1; });
  return variable.is_numeric() && dimensions.size() >= 2 && long_ones <= 2;
}

bool is_called_bathymetry(const NetcdfVariable& variable) {
  constexpr std::array<std::string_view, 16> names{
      "elevation", "deptho", "z",     "topo",     "bathymetry", "bathy",      "depth",  "h",
      "hdept",     "rose",   "band1", "altitude", "relief",     "topography", "height", "bedrock"};
  const std::string name = lower(variable.name());
  const std::string standard_name = lower(variable.attribute("standard_name"));
  const std::string long_name = lower(variable.attribute("long_name"));
  if (contains_any(standard_name + " " + long_name,
                   {"sea_surface", "sea surface", "dynamic", "wave", "sea_ice", "sea ice", "mixed_layer",
                    "mixed layer", "wind"}))
    return false;
  return std::find(names.begin(), names.end(), name) != names.end() ||
         contains_any(standard_name, {"sea_floor_depth", "bedrock_altitude", "surface_altitude"}) ||
         contains_any(long_name,
                      {"bathymetr", "topograph", "relief of", "sea floor depth", "elevation relative"});
}

/// A two-dimensional table of longitudes or latitudes over the variable's own horizontal dimensions; null
/// when none.
const NetcdfVariable* table_of(const NetcdfFile& file, const NetcdfVariable& variable,
                               const NetcdfLayout& layout, AxisRole role) {
  const std::string& x = variable.dimensions()[layout.x_dimension].name;
  const std::string& y = variable.dimensions()[layout.y_dimension].name;
  for (const NetcdfVariable& table : file.variables())
    if (table.dimensions().size() == 2 && table.dimensions()[0].name == y &&
        table.dimensions()[1].name == x && role_of(table) == role)
      return &table;
  return nullptr;
}

/// Whether the file's own tables of positions put a corner of the grid elsewhere than its projection does.
/// Files with a projection on a sphere, or in units that are not what they say, are many kilometres off.
bool contradicts_tables(const NetcdfFile& file, const NetcdfVariable& variable, const NetcdfLayout& layout,
                        const ocean::HorizontalGrid& grid) {
  const NetcdfVariable* lon_table = table_of(file, variable, layout, AxisRole::longitude);
  const NetcdfVariable* lat_table = table_of(file, variable, layout, AxisRole::latitude);
  if (lon_table == nullptr || lat_table == nullptr) return false;
  const auto lon = lon_table->read_all();
  const auto lat = lat_table->read_all();
  if (!lon || !lat) return true;

  const std::size_t columns = static_cast<std::size_t>(variable.dimensions()[layout.x_dimension].size);
  for (const bool far_corner : {false, true}) {
    const std::size_t ix = far_corner ? grid.x().size() - 1 : 0;
    const std::size_t iy = far_corner ? grid.y().size() - 1 : 0;
    const std::size_t node = layout.y.source[iy] * columns + layout.x.source[ix];
    const core::Metres apart = geo::geodesic_between(grid.place(ix, iy), {(*lon)[node], (*lat)[node]}).length;
    if (!(apart < 0.1 * grid.spacing())) return true;
  }
  return false;
}

Checked<ocean::HorizontalGrid> grid_of(const NetcdfFile& file, const NetcdfVariable& variable,
                                       const NetcdfLayout& layout, const IngestOptions& options) {
  ocean::Axis x{layout.x.nodes};
  ocean::Axis y{layout.y.nodes};
  if (!layout.projected) return ocean::HorizontalGrid{geo::GeographicFrame{}, std::move(x), std::move(y)};

  OGRSpatialReference crs;
  if (const auto stated = variable.crs()) {
    crs = *stated;
  } else if (!options.crs || crs.SetFromUserInput(options.crs->c_str()) != OGRERR_NONE) {
    return refuse("the grid of \"" + variable.name() +
                  "\" is projected, but the file does not say how; it cannot be placed on the Earth; state "
                  "the projection with --crs, for example --crs EPSG:3413");
  }
  const auto frame = grid_frame_of(crs);
  if (!frame)
    return refuse("the grid of \"" + variable.name() +
                  "\" is in a projection that this program cannot use from NetCDF; convert it first, for "
                  "example with gdalwarp -t_srs EPSG:4326");
  ocean::HorizontalGrid grid{*frame, std::move(x), std::move(y)};
  if (contradicts_tables(file, variable, layout, grid))
    return refuse(
        "the grid of \"" + variable.name() +
        "\" lies elsewhere by its projection than by its own tables of longitude and latitude; the sea floor "
        "would be out of place; convert it first to a regular longitude-latitude grid, using the tables");
  return grid;
}

}  // namespace

const NetcdfVariable* find_bathymetry(const NetcdfFile& file, bool any_plane) {
  const NetcdfVariable* only_plane = nullptr;
  std::size_t planes = 0;
  for (const NetcdfVariable& variable : file.variables()) {
    const bool plane = is_plane(variable);
    if ((plane || unsupported_grid(file, variable)) && is_called_bathymetry(variable)) return &variable;
    if (!plane) continue;
    only_plane = &variable;
    ++planes;
  }
  return any_plane && planes == 1 ? only_plane : nullptr;
}

Checked<PreparedDataset> read_netcdf_bathymetry(const NetcdfFile& file, const IngestOptions& options) {
  const NetcdfVariable* variable = find_bathymetry(file, options.kind.has_value());
  if (variable == nullptr)
    return refuse(
        "the file holds no depths or elevations that this program recognises; there is no bathymetry to "
        "store; give a file with, for example, a variable called elevation or deptho");
  const auto layout = layout_of(file, *variable);
  if (!layout) return refuse(layout.error());
  auto grid = grid_of(file, *variable, *layout, options);
  if (!grid) return refuse(grid.error());

  const std::string unit = variable->attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse("the variable \"" + variable->name() + "\" has the unit \"" + unit +
                  "\", which is no length that this program knows; ask for a file in metres");
  const auto values = read_slice(*variable, *layout, 0, 0);
  if (!values) return refuse(values.error());

  RawBathymetry raw{.grid = std::move(*grid),
                    .values_m = {},
                    .description = {.name = variable->name(),
                                    .standard_name = variable->attribute("standard_name"),
                                    .long_name = variable->attribute("long_name"),
                                    .positive = variable->attribute("positive")},
                    .warnings = layout->warnings};
  raw.values_m.reserve(values->size());
  for (const double value : *values) raw.values_m.push_back(static_cast<float>(value * *factor));
  if (unit.empty()) raw.warnings.push_back("\"" + variable->name() + "\" states no unit; taken as metres");
  return prepare_bathymetry(std::move(raw), options.positive);
}

}  // namespace floeplan::ingest
