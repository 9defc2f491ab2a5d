#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/s100/s100_coverage.hpp"

namespace floeplan::ingest {

/// Joins scattered places, whose neighbours are not stated, to triangles (Delaunay), in the plane that
/// touches the Earth in their middle. Triangles with a side longer than 1.35 times the median length are
/// dropped. On a square grid the diagonals then stay, and a missing node, as over land, leaves a hole.
/// Outside  nullopt for fewer than three places, for places on a line, and for places half the Earth apart
[[nodiscard]] std::optional<ocean::Mesh> mesh_of_places(std::vector<geo::LonLat> places);

/// The mesh of an S-100 product, and its layout in words.
struct S100Mesh {
  ocean::Mesh mesh;
  std::string layout;
};
/// The triangles of the file; without any, its places are joined as `mesh_of_places` does.
/// Errors  the places enclose no area
[[nodiscard]] Checked<S100Mesh> mesh_of(const S100Points& points);

}  // namespace floeplan::ingest
