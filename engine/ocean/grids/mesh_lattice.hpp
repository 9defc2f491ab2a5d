#pragma once

#include <cstddef>
#include <optional>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ocean {

/// The regular grid onto which the values of a whole mesh are interpolated: about as fine as the mesh where it is fine,
/// as long as the grid stays within what a job can hold. In longitude and latitude; polar stereographic where the mesh
/// lies round or near a pole, because meridians crowd there.
/// Outside  nullopt for a mesh of no extent
[[nodiscard]] std::optional<HorizontalGrid> lattice_for(const Mesh& mesh);

/// Part of such a grid, its steps divided evenly so that they are half as long as the fine sides of the part of the mesh
/// that lies there; with at most four nodes for each of the part's points and a million, or none more than `lattice` has.
/// A lattice all round the globe stays as it is.
[[nodiscard]] HorizontalGrid refined(const HorizontalGrid& lattice, const Mesh& part);
/// Nodes that such a part has at most, of so many points.
[[nodiscard]] std::size_t most_nodes_refined(const HorizontalGrid& lattice, std::size_t points);

}  // namespace floeplan::ocean
