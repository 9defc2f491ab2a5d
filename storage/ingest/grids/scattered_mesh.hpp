#pragma once

#include <optional>
#include <vector>

#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ingest {

/// Joins places that say nothing of their neighbours to triangles (Delaunay), seen in the plane that touches the Earth
/// in their middle. A triangle with a side longer than 1.35 times what half of the triangles do not exceed is none: of a
/// square grid the diagonals stay, and a node that is missing, as over land, leaves a hole.
/// Outside  nullopt for fewer than three places, for places on a line, and for places that half the Earth lies between
[[nodiscard]] std::optional<ocean::Mesh> mesh_of_places(std::vector<geo::LonLat> places);

}  // namespace floeplan::ingest
