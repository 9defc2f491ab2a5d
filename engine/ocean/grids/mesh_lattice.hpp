#pragma once

#include <cstddef>
#include <optional>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ocean {

/// The regular grid to which the values of a whole mesh are interpolated: about as fine as the finest part of
/// the mesh, within the memory of a job. In longitude and latitude; polar stereographic if the mesh lies
/// around or near a pole, because meridians converge there.
/// Outside  nullopt for a mesh without extent
[[nodiscard]] std::optional<HorizontalGrid> lattice_for(const Mesh& mesh);

/// Part of such a grid with divided steps, so that they are half as long as the fine sides in this part of
/// the mesh. It has at most four nodes per point of the part and a million in all, or no more than `lattice`.
/// A lattice all round the globe stays unchanged.
[[nodiscard]] HorizontalGrid refined(const HorizontalGrid& lattice, const Mesh& part);
/// Largest number of nodes of such a part with this number of points.
[[nodiscard]] std::size_t most_nodes_refined(const HorizontalGrid& lattice, std::size_t points);

}  // namespace floeplan::ocean
