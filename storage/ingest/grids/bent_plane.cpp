#include "storage/ingest/grids/bent_plane.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/row_mesh.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// "0.05 x 0.025 degrees of longitude and latitude", "12000 m of a polar stereographic projection".
std::string spacing_in_words(const ocean::HorizontalGrid& grid) {
  const bool metres = !std::holds_alternative<geo::GeographicFrame>(grid.frame());
  const std::string x = number(grid.x().mean_step(), metres ? 6 : 3);
  const std::string y = number(grid.y().mean_step(), 3);
  if (metres) return x + " m of a polar stereographic projection";
  return x + " x " + y + " degrees of longitude and latitude";
}

/// Calls `take` with the four nodes around a place; not at all for a place outside the grid.
template <class Take>
void for_each_node_around(const ocean::HorizontalGrid& grid, geo::LonLat place, const Take& take) {
  if (!geo::is_valid(place)) return;
  const auto at = grid.locate(place);
  if (!at) return;
  const std::size_t columns = grid.x().size();
  for (const std::size_t y : {at->y.lower, at->y.upper})
    for (const std::size_t x : {at->x.lower, at->x.upper}) take(y * columns + x);
}

}  // namespace

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
  std::vector<geo::LonLat> points = std::move((*positions)->places);
  const ocean::Mesh mesh = mesh_of_rows(points, (*positions)->columns);
  auto grid = ocean::lattice_for(mesh);
  if (!grid) return refuse(messages::ingest_grid_message<"positions-enclose-no-area">());
  auto sampling = ocean::MeshSampling::of(mesh, *grid);
  if (!sampling) return refuse(messages::ingest_grid_message<"cells-overlap">());
  messages::Message account = messages::ingest_grid_message<"resampled-from-bent-grid">(
      variable.name(), (*positions)->rows, (*positions)->columns, spacing_in_words(*grid));
  return BentPlane{std::move(*layout),   std::move(points), std::move(*grid),
                   std::move(*sampling), std::move(*water), std::move(account)};
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

RawRows resampled_with_range(const BentPlane& plane, std::span<const float> values) {
  RawRows rows;
  rows.values_m = plane.sampling.apply(values);
  rows.lowest_m = rows.values_m;
  rows.highest_m = rows.values_m;
  for (std::size_t point = 0; point < values.size(); ++point) {
    const float value = values[point];
    if (std::isnan(value)) continue;
    for_each_node_around(plane.grid, plane.points[point], [&](std::size_t node) {
      if (value < rows.lowest_m[node]) rows.lowest_m[node] = value;  // not where the node itself is missing
      if (value > rows.highest_m[node]) rows.highest_m[node] = value;
    });
  }
  return rows;
}

}  // namespace floeplan::ingest
