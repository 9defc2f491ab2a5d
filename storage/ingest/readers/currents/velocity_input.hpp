#pragma once

#include <optional>
#include <string>

#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// Two components on whatever layout they have: regular grids are to be kept on their axes, every other one at its own points.
/// Currents without an axis of depth that say that they are of the surface or at one depth get that level; means over
/// the water column stay without one.
/// `stated_crs`  the projection of a file that states none
/// Errors   levels above the surface; see rectilinear_currents, curvilinear_currents and mesh_currents
[[nodiscard]] Checked<CurrentInput> velocity_input(const NetcdfFiles& files, const VelocityPair& pair,
                                                   const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest
