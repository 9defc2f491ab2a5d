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

/// Along what each point of a mesh knows the current, where every point knows one of its two components.
/// Units  radians counterclockwise from east
/// Shape  as the points; NaN at those of the other component
struct ComponentAxes {
  std::vector<float> first_rad;
  std::vector<float> second_rad;
};

/// Interpolates the currents of an Arakawa C grid at the nodes of a grid. Each component is known at points of its own,
/// in the faces between the cells of the model, and is interpolated between these alone; only then both are turned to
/// true east and true north, by the axes at the node. At a point of the model its component is the model's own.
/// Between  linear along the component's own axis from one face of a model cell to the next, so that nothing flows
///          through a closed face; linear across it between two open faces
/// Coast    a closed face has the value 0. Across the axis a closed or unknown face and an open one are not mixed: the
///          nearer one counts, so that water flows along a coast without being slowed down. Along the axis the known one
///          of two counts up to half-way to the other. A model cell without an open face amid water is land
/// Outside  no value where either component has none
/// Threads  const members may be called from several threads at once
/// Source   Arakawa and Lamb 1977, Methods in Computational Physics 17, grid C; the way between the faces: Döös et al.
///          2017, Geosci. Model Dev. 10, section 2.1, and Delandmeter and van Sebille 2019, Geosci. Model Dev. 12,
///          section 2.1.2, where a component is constant across its axis. Here it is linear between open faces, as the
///          currents of other grids are
class StaggeredSampling {
 public:
  /// `mesh`        each cell has points of one component, its first side along that component's axis
  /// Precondition  as of MeshSampling
  /// Outside       nullopt as of MeshSampling
  [[nodiscard]] static std::optional<StaggeredSampling> of(const Mesh& mesh, const ComponentAxes& axes,
                                                           const HorizontalGrid& grid);

  /// Shape  input: as the points; output: the grid [y][x]
  [[nodiscard]] PointVelocities apply(std::span<const float> components) const;
  /// What has no direction, at each node between the points of the first and of the second component.
  [[nodiscard]] std::pair<std::vector<float>, std::vector<float>> apply_to_numbers(
      std::span<const float> values) const;

 private:
  /// One node among four points of a component: how far it lies along the first side of the cell and across it, and the
  /// direction of the axis there.
  struct Stencil {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4>
        sign{};  // -1: the axis there points the other way, as beyond the fold of a tripolar grid
    float along{};
    float across{};
    float stretch{1.0F};
    float cosine{};  // both 0: in no cell
    float sine{};
  };
  /// A component, and whether the model cell round the node is closed on that axis while water moves beside it.
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
