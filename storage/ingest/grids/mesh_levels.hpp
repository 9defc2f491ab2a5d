#pragma once

#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/mesh_topology.hpp"

namespace floeplan::ingest {

/// Where the levels of a mesh lie that follow the sea bed.
struct MeshLevels {
  std::shared_ptr<const BedLevels> levels;
  bool in_faces{false};  // known in the faces of the mesh, else at its nodes
};

/// The levels along which a variable of a mesh lies:
///  - by a table of their heights at every point and time (SCHISM's zcor); the uppermost is the surface, the lowest the
///    bed
///  - by the formula of an ocean_sigma_coordinate: shares of the way from the surface (0) to the bed (-1), with the
///    variables that the formula names (Delft3D FM), else FVCOM's siglay, h and zeta; the mean surface, with a warning,
///    where the file has none
/// Errors   levels or depths that are missing or impossible; coordinates of another formula
/// Source   CF conventions 1.8, appendix D, ocean_sigma_coordinate
[[nodiscard]] Checked<MeshLevels> mesh_levels(const std::shared_ptr<const NetcdfFile>& file,
                                              const NetcdfVariable& variable, const NetcdfLayout& layout,
                                              const MeshTopology& mesh, Messages& warnings);

}  // namespace floeplan::ingest
