#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/currents/component_source.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

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

}  // namespace floeplan::ingest
