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

/// Whether the file's own tables of positions put a corner of the grid elsewhere than its projection. A
/// projection on a sphere, or a wrong unit, leads to differences of many kilometres.
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
  if (contradicts_tables(file, variable, layout, grid))
    return refuse(messages::ingest_netcdf_message<"projection-contradicts-tables">(variable.name()));
  return grid;
}

}  // namespace floeplan::ingest
