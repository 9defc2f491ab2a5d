#pragma once

#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/mesh_topology.hpp"

namespace floeplan::ingest {

/// Levels of a mesh that follow the sea bed.
struct MeshLevels {
  std::shared_ptr<const BedLevels> levels;
  bool in_faces{false};  // true: their depths are known in the faces of the mesh; false: at its nodes
};

/// The levels of a variable on a mesh:
///  - from a table of their heights at every point and time (SCHISM's zcor); the uppermost is the surface,
///    the lowest the bed
///  - from the formula of an ocean_sigma_coordinate: fractions of the water depth from the surface (0) to the
///    bed (-1), with the variables that the formula names (Delft3D FM), or with FVCOM's siglay, h and zeta.
///    If the file has no elevation of the surface, the mean surface is used, with a warning
/// Errors   levels or depths that are missing or impossible; a coordinate with another formula
/// Source   CF conventions 1.8, appendix D, ocean_sigma_coordinate
[[nodiscard]] Checked<MeshLevels> mesh_levels(const std::shared_ptr<const NetcdfFile>& file,
                                              const NetcdfVariable& variable, const NetcdfLayout& layout,
                                              const MeshTopology& mesh, Messages& warnings);

}  // namespace floeplan::ingest
