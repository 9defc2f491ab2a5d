#pragma once

#include <optional>
#include <string>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"

namespace floeplan::ingest {

/// Where the nodes of a variable lie: in longitude and latitude, or in the projection that the file states, else
/// in `stated_crs` ("EPSG:3413").
/// Errors   a projection that is not stated or cannot be used; one that puts the grid elsewhere than the file's own
///          tables of longitude and latitude do
[[nodiscard]] Checked<ocean::HorizontalGrid> grid_of(const NetcdfFile& file, const NetcdfVariable& variable,
                                                     const NetcdfLayout& layout,
                                                     const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest
