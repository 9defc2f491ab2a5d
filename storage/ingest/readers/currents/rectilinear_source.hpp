#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// A source whose points are the nodes of a regular grid, so that it is stored as it is.
struct RectilinearCurrents {
  std::shared_ptr<const VelocitySource> source;
  ocean::HorizontalGrid grid;
};

/// Currents on one axis of x and one of y, geographic or projected. Components along the axes of a projection are
/// turned to true east and north at every node.
/// Errors   components of different shape, time or depth; a unit that is no speed; components on a projected grid that
///          do not say what they are along
[[nodiscard]] Checked<RectilinearCurrents> rectilinear_currents(const NetcdfFiles& files,
                                                                const VelocityPair& pair,
                                                                const std::optional<std::string>& stated_crs,
                                                                Messages& warnings);

}  // namespace floeplan::ingest
