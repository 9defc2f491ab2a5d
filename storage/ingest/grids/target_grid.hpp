#pragma once

#include <string>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/grids/source_mesh.hpp"

namespace floeplan::ingest {

/// The regular grid on which the currents of a mesh are stored: about as fine as the mesh where it is fine, as long as
/// the grid stays within what a job can hold. In longitude and latitude; polar stereographic where the mesh lies round
/// or near a pole, because meridians crowd there.
/// Errors   a mesh of no extent
[[nodiscard]] Checked<ocean::HorizontalGrid> target_grid_for(const SourceMesh& mesh);

/// "longitude and latitude, 0.05 x 0.025 degrees", "polar stereographic, 12000 m".
[[nodiscard]] std::string spacing_in_words(const ocean::HorizontalGrid& grid);

}  // namespace floeplan::ingest
