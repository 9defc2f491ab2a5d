#pragma once

#include <optional>
#include <vector>

#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ingest {

/// Joins scattered places, whose neighbours are not stated, to triangles (Delaunay), in the plane that
/// touches the Earth in their middle. Triangles with a side longer than 1.35 times the median length are
/// dropped. On a square grid the diagonals then stay, and a missing node, as over land, leaves a hole.
/// Outside  nullopt for fewer than three places, for places on a line, and for places half the Earth apart
[[nodiscard]] std::optional<ocean::Mesh> mesh_of_places(std::vector<geo::LonLat> places);

}  // namespace floeplan::ingest
