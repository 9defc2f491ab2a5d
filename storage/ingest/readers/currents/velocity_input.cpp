#include "storage/ingest/readers/currents/velocity_input.hpp"

#include <algorithm>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/formats/netcdf/netcdf_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/grids/mesh_topology.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/velocity_sources.hpp"

namespace floeplan::ingest {
namespace {

/// Whether each of the two horizontal dimensions has its own axis, geographic or projected.
bool has_plain_axes(const NetcdfFile& file, const NetcdfVariable& variable) {
  const auto plane = plane_of(file, variable);
  if (!plane) return false;
  for (const std::size_t dimension : {plane->y, plane->x}) {
    const NetcdfVariable* coordinate = coordinate_of(file, variable.dimensions()[dimension]);
    const AxisRole role = coordinate == nullptr ? AxisRole::unknown : role_of(*coordinate);
    if (role != AxisRole::longitude && role != AxisRole::latitude && role != AxisRole::projected_x &&
        role != AxisRole::projected_y)
      return false;
  }
  return true;
}

bool have_positions(const NetcdfFiles& files, const VelocityPair& pair) {
  const auto plane = plane_of(*pair.first_file, *pair.first);
  return plane && has_positions(files, *pair.first_file, *pair.first, *plane);
}

/// Whether the dimensions have ROMS' or CROCO's names. The tables of positions may then be in another file.
bool is_roms(const VelocityPair& pair) {
  return std::ranges::any_of(pair.first->dimensions(), [](const NetcdfDimension& dimension) {
    return lower(dimension.name).starts_with("xi_");
  });
}

/// Whether levels follow the sea bed. Such levels are read by the reader of curvilinear grids, whatever the
/// grid.
bool has_bed_levels(const VelocityPair& pair) {
  return std::ranges::any_of(pair.first->dimensions(), [&](const NetcdfDimension& dimension) {
    const NetcdfVariable* coordinate = coordinate_of(*pair.first_file, dimension);
    return dimension.size > 1 && coordinate != nullptr && role_of(*coordinate) == AxisRole::model_level;
  });
}

/// Whether the components lie at different points. One set of plain axes cannot then describe both.
bool are_staggered(const VelocityPair& pair) {
  const auto first = plane_of(*pair.first_file, *pair.first);
  const auto second = plane_of(*pair.second_file, *pair.second);
  if (!first || !second) return false;
  const auto& a = pair.first->dimensions();
  const auto& b = pair.second->dimensions();
  return a[first->y].name != b[second->y].name || a[first->x].name != b[second->x].name;
}

/// Whether the currents are stored on the axes of their file. They are not if tables of true positions show
/// that the axes are only nominal or contradict their projection; nor if the components are staggered.
bool lie_on_axes(const NetcdfFiles& files, const VelocityPair& pair,
                 const std::optional<std::string>& stated_crs) {
  if (!has_plain_axes(*pair.first_file, *pair.first)) return false;
  const bool positions = have_positions(files, pair);
  const auto layout = layout_of(*pair.first_file, *pair.first);
  if (!layout) return true;  // the fault of the axes is reported when they are read
  if (layout->projected && positions)
    return grid_of(*pair.first_file, *pair.first, *layout, stated_crs).has_value();
  return !are_staggered(pair) && !(positions && pair.axes == VelocityAxes::grid);
}

/// Prepares two components without looking at their names for a depth.
Checked<CurrentInput> input_as_laid_out(const NetcdfFiles& files, const VelocityPair& pair,
                                        const std::optional<std::string>& stated_crs) {
  CurrentInput input;
  input.what = pair.what;
  input.warnings = pair.warnings;
  input.variables = {pair.first->name(), pair.second->name()};
  input.states_unit = !pair.first->attribute("units").empty();

  if (lies_on_mesh(*pair.first_file, *pair.first)) {
    auto mesh = mesh_currents(files, pair, input.warnings);
    if (!mesh) return refuse(mesh.error());
    input.source = std::move(mesh->source);
    input.mesh = std::move(mesh->mesh);
    input.layout = std::move(mesh->layout);
    return input;
  }
  const bool bent_grid = have_positions(files, pair) || are_staggered(pair) || is_roms(pair);
  if (!has_bed_levels(pair) && (lie_on_axes(files, pair, stated_crs) || !bent_grid)) {
    auto regular = rectilinear_currents(files, pair, stated_crs, input.warnings);
    if (!regular) return refuse(regular.error());
    input.source = std::move(regular->source);
    input.grid = std::move(regular->grid);
    return input;
  }
  auto bent = curvilinear_currents(files, pair, input.warnings);
  if (!bent) return refuse(bent.error());
  input.source = std::move(bent->source);
  input.components = std::move(bent->components);
  input.mesh = std::move(bent->mesh);
  input.layout = std::move(bent->layout);
  return input;
}

/// Gives currents without a depth axis the depth in their names.
void place_by_words(CurrentInput& input, const VelocityPair& pair) {
  const SourceShape& shape = input.source->shape();
  if (shape.depths_m || shape.levels_follow_bed) return;
  const std::string names = "\"" + pair.first->name() + "\" and \"" + pair.second->name() + "\"";
  if (pair.depth_m) {
    input.warnings.push_back(
        messages::ingest_current_message<"current-of-one-depth">(names, number(*pair.depth_m)));
    keep_level(input, 0, *pair.depth_m);
  } else if (pair.part == WaterPart::surface) {
    input.warnings.push_back(messages::ingest_current_message<"current-of-the-surface">(names));
    keep_level(input, 0, 0.0);
  } else if (pair.part == WaterPart::column_mean) {
    input.warnings.push_back(messages::ingest_current_message<"current-of-the-column">(names));
  } else {
    input.warnings.push_back(messages::ingest_current_message<"current-without-depth">(names));
  }
}

}  // namespace

Checked<CurrentInput> velocity_input(const NetcdfFiles& files, const VelocityPair& pair,
                                     const std::optional<std::string>& stated_crs) {
  auto input = input_as_laid_out(files, pair, stated_crs);
  if (!input || pair.what == Moving::air) return input;
  const auto& depths_m = input->source->shape().depths_m;
  if (depths_m && depths_m->back() < 0.0)
    return refuse(messages::ingest_current_message<"current-above-the-surface">(
        pair.first->name(), pair.second->name(), number(-depths_m->front())));
  place_by_words(*input, pair);
  return input;
}

}  // namespace floeplan::ingest
