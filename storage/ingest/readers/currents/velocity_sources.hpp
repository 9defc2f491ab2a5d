#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/currents/component_source.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// A source whose points are the nodes of a regular grid, so that its values are stored unchanged.
struct RectilinearCurrents {
  std::shared_ptr<const VelocitySource> source;
  ocean::HorizontalGrid grid;
};

/// Currents with one axis for x and one for y, geographic or projected. Components along the axes of a
/// projection are rotated to true east and north at every node.
/// Errors   components of different shape, time or depth; a unit that is not a speed; components on a
///          projected grid whose direction is not stated
[[nodiscard]] Checked<RectilinearCurrents> rectilinear_currents(const NetcdfFiles& files,
                                                                const VelocityPair& pair,
                                                                const std::optional<std::string>& stated_crs,
                                                                Messages& warnings);

/// A source together with the mesh of its points.
struct MeshCurrents {
  std::shared_ptr<const VelocitySource> source;
  ocean::Mesh mesh;
  std::string layout;  // in words, as "a bent grid"
  /// For a staggered grid: each point of the mesh is a point of one component, and the source's points are
  /// the centres between them. Null: the points of the mesh are the source's.
  std::shared_ptr<const ComponentSource> components{};
};

/// Currents whose points lie in rows and columns of any shape, with both components at the same points (A and
/// B grids) or half a cell apart (C grids): NEMO, ROMS, CROCO, MOM, POP, polar projections. Components at the
/// same points are rotated to true east and north; other components are stored along their axes and rotated
/// when they are used.
/// Errors   no tables of positions; unknown directions of the components; levels without known depth; those
///          of staggering_of and directions_of
[[nodiscard]] Checked<MeshCurrents> curvilinear_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                         Messages& warnings);

/// Currents on a mesh of triangles, quadrilaterals and faces of up to twelve corners, at its nodes or in its
/// faces, on depths or on sigma levels: FVCOM, SELFE, SCHISM and files with the UGRID conventions. Values in
/// faces are put at the middles of the faces, as ocean::Mesh needs it.
/// Errors   those of mesh_topology; components that do not point east and north; levels without known depth
[[nodiscard]] Checked<MeshCurrents> mesh_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                  Messages& warnings);

}  // namespace floeplan::ingest
