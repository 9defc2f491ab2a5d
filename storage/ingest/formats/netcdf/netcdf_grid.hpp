#pragma once

#include <optional>
#include <string>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"

namespace floeplan::ingest {

/// The grid of a variable's nodes: in longitude and latitude, or in the projection that the file states; if
/// it states none, in `stated_crs` ("EPSG:3413").
/// Errors   no projection is stated, or it cannot be used; the projection puts the grid elsewhere than the
///          file's own tables of longitude and latitude
[[nodiscard]] Checked<ocean::HorizontalGrid> grid_of(const NetcdfFile& file, const NetcdfVariable& variable,
                                                     const NetcdfLayout& layout,
                                                     const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest
