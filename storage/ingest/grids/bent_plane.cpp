#include "storage/ingest/grids/bent_plane.hpp"

#include <utility>

#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/row_mesh.hpp"

namespace floeplan::ingest {
std::vector<float> BentPlane::as_kept(std::span<const float> values) const {
  std::vector<float> kept;
  kept.reserve(own.sources.size());
  for (const std::uint32_t point : own.sources) kept.push_back(values[point]);
  return kept;
}

Checked<std::optional<BentPlane>> bent_plane_of(const std::shared_ptr<const NetcdfFile>& file,
                                                const NetcdfVariable& variable) {
  const auto plane = plane_of(*file, variable);
  if (!plane || !has_positions({file}, *file, variable, *plane)) return std::nullopt;
  auto layout = layout_over(*file, variable, plane->y, plane->x);
  if (!layout) return refuse(layout.error());
  auto positions = positions_of({file}, *file, variable, *plane, GridPoints::centres);
  if (!positions) return refuse(positions.error());
  if (!*positions || (*positions)->from_plain_axes) return std::nullopt;

  auto water = mask_over({file}, variable, *plane, "mask_rho");
  if (!water) return refuse(water.error());
  const ocean::Mesh mesh = mesh_of_rows(std::move((*positions)->places), (*positions)->columns);
  auto grid = ocean::lattice_for(mesh);
  if (!grid) return refuse(messages::ingest_grid_message<"positions-enclose-no-area">());
  if (!ocean::MeshSampling::of(mesh, *grid)) return refuse(messages::ingest_grid_message<"cells-overlap">());
  return BentPlane{std::move(*layout), repository::in_blocks(mesh), std::move(*grid), std::move(*water)};
}

Checked<PlacedVariable> place_of(const std::shared_ptr<const NetcdfFile>& file,
                                 const NetcdfVariable& variable,
                                 const std::optional<std::string>& stated_crs) {
  auto layout = layout_of(*file, variable);
  auto grid = layout ? grid_of(*file, variable, *layout, stated_crs)
                     : Checked<ocean::HorizontalGrid>{refuse(layout.error())};
  if (grid) return PlacedVariable{std::move(*layout), std::move(*grid), std::nullopt};
  auto bent = bent_plane_of(file, variable);
  if (!bent) return refuse(bent.error());
  if (!*bent) return refuse(grid.error());
  return PlacedVariable{(*bent)->layout, (*bent)->grid, std::move(*bent)};
}

}  // namespace floeplan::ingest
