#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"

#include <ogr_spatialref.h>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_projection.hpp"
#include "storage/ingest/notation/crs_text.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"

namespace floeplan::ingest {
namespace {

/// A two-dimensional table of longitudes or latitudes over the variable's own horizontal dimensions; null if
/// there is none.
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

/// Largest distance between a node in the file's tables and by its projection, as a share of the spacing. A file may
/// state a sphere for places that were computed on an ellipsoid; near a pole the two differ little.
double most_apart(const geo::GridFrame& frame) {
  const bool on_sphere = std::visit(
      [](const auto& any) {
        if constexpr (requires { any.ellipsoid; }) return any.ellipsoid.inverse_flattening == 0.0;
        return false;
      },
      frame);
  return on_sphere ? 0.01 : 0.1;
}

/// Whether the file's own tables of positions put a corner of the grid elsewhere than its projection. A wrong figure
/// of the Earth or a wrong unit leads to differences of many kilometres.
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
    if (!(apart < most_apart(grid.frame()) * grid.spacing())) return true;
  }
  return false;
}

}  // namespace

Checked<ocean::HorizontalGrid> grid_of(const NetcdfFile& file, const NetcdfVariable& variable,
                                       const NetcdfLayout& layout,
                                       const std::optional<std::string>& stated_crs) {
  ocean::Axis x{layout.x.nodes};
  ocean::Axis y{layout.y.nodes};
  if (!layout.projected) return ocean::HorizontalGrid{geo::GeographicFrame{}, std::move(x), std::move(y)};

  OGRSpatialReference crs;
  if (const auto stated = projection_of(file, variable)) {
    crs = *stated;
  } else if (!stated_crs || !read_crs(*stated_crs, crs)) {
    return refuse(messages::ingest_netcdf_message<"projection-not-stated">(variable.name()));
  }
  const auto frame = grid_frame_of(crs);
  if (!frame) return refuse(messages::ingest_netcdf_message<"projection-not-usable">(variable.name()));
  ocean::HorizontalGrid grid{*frame, std::move(x), std::move(y)};
  if (!lies_in_projection(grid))
    return refuse(messages::ingest_netcdf_message<"projection-not-usable">(variable.name()));
  if (contradicts_tables(file, variable, layout, grid))
    return refuse(messages::ingest_netcdf_message<"projection-contradicts-tables">(variable.name()));
  return grid;
}

}  // namespace floeplan::ingest
