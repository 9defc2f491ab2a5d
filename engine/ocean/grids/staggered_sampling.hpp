#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "engine/ocean/grids/point_velocities.hpp"

namespace floeplan::ocean {

/// Direction of the current component that each point of a mesh carries. Each point carries one of the two
/// components.
/// Units  radians counterclockwise from east
/// Shape  one value per point of the mesh in each member; NaN at points of the other component
struct ComponentAxes {
  std::vector<float> first_rad;
  std::vector<float> second_rad;
};

/// Interpolates the currents of an Arakawa C grid to the nodes of a regular grid. There each component is
/// given at its own points, on the faces between the model's cells. It is interpolated between these points
/// alone. Then both components are rotated to true east and north, by the axes at the node. At a point of the
/// model its component is the model's own.
/// Between  along the component's own axis linear from one face of a model cell to the next, so that nothing
///          flows through a closed face; across the axis linear between two open faces
/// Coast    A closed face has the value 0. Across the axis a closed or unknown face is not mixed with an open
///          one: the nearer one counts, so that a coast does not slow the water beside it. Along the axis, if
///          only one face is known, it counts up to half-way. A model cell without an open face inside water
///          is land
/// Outside  no value if either component has none
/// Threads  const members may be called from several threads at once
/// Source   Arakawa and Lamb 1977, Methods in Computational Physics 17, grid C; interpolation between faces:
///          Döös et al. 2017, Geosci. Model Dev. 10, section 2.1, and Delandmeter and van Sebille 2019,
///          Geosci. Model Dev. 12, section 2.1.2, where a component is constant across its axis. Here it is
///          linear between open faces, as the currents of other grids are
class StaggeredSampling {
 public:
  /// `mesh`        each cell has points of one component; its first side lies along that component's axis
  /// Precondition  as for MeshSampling
  /// Outside       nullopt as for MeshSampling
  [[nodiscard]] static std::optional<StaggeredSampling> of(const Mesh& mesh, const ComponentAxes& axes,
                                                           const HorizontalGrid& grid);

  /// Shape  input: as the points of the mesh; output: the grid [y][x]
  [[nodiscard]] PointVelocities apply(std::span<const float> components) const;
  /// Interpolates scalars to each node, separately from the points of the first and of the second component.
  [[nodiscard]] std::pair<std::vector<float>, std::vector<float>> apply_to_numbers(
      std::span<const float> values) const;

 private:
  /// One node among four points of a component: its position along the first side of the cell and across it,
  /// and the direction of the axis there.
  struct Stencil {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4>
        sign{};  // -1: the axis there points the opposite way, as beyond the fold of a tripolar grid
    float along{};
    float across{};
    float stretch{1.0F};
    float cosine{};  // both 0: the node lies in no cell
    float sine{};
  };
  /// A component at a node. `closed`: the model cell around it is closed on this axis; `moves_beside`: water
  /// moves next to it.
  struct Flow {
    float value{missing_sample};
    bool closed{false};
    bool moves_beside{false};
  };
  class Builder;

  StaggeredSampling(std::vector<Stencil> first, std::vector<Stencil> second)
      : first_{std::move(first)}, second_{std::move(second)} {}

  [[nodiscard]] static Flow flow(const Stencil& stencil, std::span<const float> components);

  std::vector<Stencil> first_;
  std::vector<Stencil> second_;
};

}  // namespace floeplan::ocean
