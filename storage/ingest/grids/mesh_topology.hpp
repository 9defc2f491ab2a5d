#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/grids/source_mesh.hpp"

namespace floeplan::ingest {

/// A horizontal mesh of triangles (or quadrilaterals) as a file describes it.
struct MeshTopology {
  std::vector<geo::LonLat> nodes;
  std::vector<SourceMesh::Cell> faces;  // corners as indices of nodes; a triangle repeats its third
  std::string node_dimension;
  std::string face_dimension;
};

/// Whether a variable lies on a mesh: along the nodes or the faces of a topology (UGRID) or along FVCOM's dimensions.
[[nodiscard]] bool lies_on_mesh(const NetcdfFile& file, const NetcdfVariable& variable);

/// The mesh of a file, by the UGRID conventions or as FVCOM writes it (nv, lon, lat).
/// Errors   no mesh; nodes without longitude and latitude; faces with corners that do not exist; more than this program
///          accepts
/// Source   UGRID conventions 1.0, section "2D triangular and flexible mesh topology"; FVCOM user manual
[[nodiscard]] Checked<MeshTopology> mesh_topology(const NetcdfFile& file);

}  // namespace floeplan::ingest
