#include "storage/ingest/grids/bent_plane.hpp"

#include <utility>

#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"

namespace floeplan::ingest {

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
  auto own = own_points_of(std::move((*positions)->places), (*positions)->columns);
  if (!own) return refuse(own.error());
  // Many cells overlap only if the tables of positions are damaged.
  if (!ocean::MeshSampling::of(own->kept.mesh, own->grid))
    return refuse(messages::ingest_grid_message<"cells-overlap">());
  return BentPlane{std::move(*layout), std::move(*own), std::move(*water)};
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
  return PlacedVariable{(*bent)->layout, (*bent)->own.grid, std::move(*bent)};
}

}  // namespace floeplan::ingest
