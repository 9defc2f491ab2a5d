#pragma once

#include <string>
#include <vector>

#include "storage/ingest/readers/currents/curvilinear_source.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// Currents on a mesh of triangles, quadrilaterals and faces of up to twelve corners, at its nodes or in its faces: FVCOM, SELFE, SCHISM and whatever
/// follows the UGRID conventions; on depths or on sigma levels. Of currents in faces the middles of the faces carry the
/// values, as ocean::Mesh has it.
/// Errors   see mesh_topology; components along anything else than east and north; levels that cannot be placed
[[nodiscard]] Checked<MeshCurrents> mesh_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                  Messages& warnings);

}  // namespace floeplan::ingest
