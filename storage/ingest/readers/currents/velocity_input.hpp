#pragma once

#include <optional>
#include <string>

#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// Prepares the two components of a velocity in any layout. Regular grids are stored on their axes, all
/// others at their own points. Currents without a depth axis get a level if their names say that they are at
/// the surface or at one depth; means over the water column get none.
/// `stated_crs`  the projection for a file that states none
/// Errors   levels above the surface; those of rectilinear_currents, curvilinear_currents and mesh_currents
[[nodiscard]] Checked<CurrentInput> velocity_input(const NetcdfFiles& files, const VelocityPair& pair,
                                                   const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest
