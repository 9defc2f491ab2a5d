#include "storage/ingest/grids/own_points.hpp"

#include <utility>

#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "storage/ingest/grids/row_mesh.hpp"

namespace floeplan::ingest {

Checked<OwnPoints> own_points_of(std::vector<geo::LonLat> places, std::size_t columns) {
  const ocean::Mesh mesh = mesh_of_rows(std::move(places), columns);
  auto grid = ocean::lattice_for(mesh);
  if (!grid) return refuse(messages::ingest_grid_message<"positions-enclose-no-area">());
  return OwnPoints{repository::in_blocks(mesh), std::move(*grid)};
}

}  // namespace floeplan::ingest
