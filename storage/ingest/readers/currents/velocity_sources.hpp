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

/// A source whose points are those of a mesh.
struct MeshCurrents {
  std::shared_ptr<const VelocitySource> source;
  ocean::Mesh mesh;
  std::string layout;  // in words: "a bent grid"
  /// Of a staggered grid: each point of the mesh is one of a component, and the source's points are the centres between
  /// them. null: the points of the mesh are the source's.
  std::shared_ptr<const ComponentSource> components{};
};

/// Currents whose points lie in rows and columns, bent in any way, with both components at the same points (A and B
/// grids) or each half a cell beside the other (C grids): NEMO, ROMS, CROCO, MOM, POP, polar projections. Collocated
/// components are turned to true east and north; others are kept along their axes, and are turned when they are used.
/// Errors   no tables of positions; components that do not say what they are along; levels that cannot be placed; see
///          staggering_of and directions_of
[[nodiscard]] Checked<MeshCurrents> curvilinear_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                         Messages& warnings);

/// Currents on a mesh of triangles, quadrilaterals and faces of up to twelve corners, at its nodes or in its faces: FVCOM, SELFE, SCHISM and whatever
/// follows the UGRID conventions; on depths or on sigma levels. Of currents in faces the middles of the faces carry the
/// values, as ocean::Mesh has it.
/// Errors   see mesh_topology; components along anything else than east and north; levels that cannot be placed
[[nodiscard]] Checked<MeshCurrents> mesh_currents(const NetcdfFiles& files, const VelocityPair& pair,
                                                  Messages& warnings);

}  // namespace floeplan::ingest
