#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/grids/bent_plane.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_grid.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"

namespace floeplan::ingest {
namespace {

/// At least two dimensions, and no more than two that are longer than one.
bool is_plane(const NetcdfVariable& variable) {
  const auto& dimensions = variable.dimensions();
  const auto long_ones =
      std::count_if(dimensions.begin(), dimensions.end(), [](const auto& d) { return d.size > 1; });
  return variable.is_numeric() && dimensions.size() >= 2 && long_ones <= 2;
}

/// A description without its reference level: "depth of the bed below the sea surface" does not describe the
/// sea surface.
std::string without_level(std::string description) {
  for (const std::string_view level : {"below sea surface", "below the sea surface", "below mean sea surface",
                                       "below the mean sea surface", "below_sea_surface"})
    if (const std::size_t at = description.find(level); at != std::string::npos)
      description.erase(at, level.size());
  return description;
}

bool is_called_bathymetry(const NetcdfVariable& variable) {
  constexpr std::array<std::string_view, 16> names{
      "elevation", "deptho", "z",     "topo",     "bathymetry", "bathy",      "depth",  "h",
      "hdept",     "rose",   "band1", "altitude", "relief",     "topography", "height", "bedrock"};
  const std::string name = lower(variable.name());
  const std::string standard_name = standard_name_of(variable);
  const std::string long_name = lower(variable.attribute("long_name"));
  if (contains_any(standard_name, {"sea_floor_depth", "bedrock_altitude", "surface_altitude"})) return true;
  if (contains_any(standard_name + " " + without_level(long_name),
                   {"sea_surface", "sea surface", "dynamic", "wave", "sea_ice", "sea ice", "mixed_layer",
                    "mixed layer", "wind"}))
    return false;
  return std::find(names.begin(), names.end(), name) != names.end() ||
         contains_any(long_name,
                      {"bathymetr", "topograph", "relief of", "sea floor depth", "elevation relative"});
}

/// The least and the greatest depth in a cell are depths too, but other variables are preferred.
bool is_extreme(Statistic statistic) {
  return statistic == Statistic::minimum || statistic == Statistic::maximum;
}

/// The depths of all points in metres, in the order in which they are kept. Values that are impossible on
/// Earth are left out, because interpolation would mix them with their neighbours.
Checked<RawRows> rows_of_bent(const NetcdfVariable& variable, const BentPlane& plane, double factor) {
  constexpr double deepest_m = 12'000.0;
  constexpr double customary_mark = 9999.0;
  auto values = read_slice(variable, plane.layout, 0, 0);
  if (!values) return refuse(values.error());
  plane.water.apply(*values);
  std::vector<float> metres;
  metres.reserve(values->size());
  for (const double value : *values) {
    const bool possible = std::abs(value * factor) <= deepest_m && std::abs(value) != customary_mark;
    metres.push_back(possible ? static_cast<float>(value * factor) : std::numeric_limits<float>::quiet_NaN());
  }
  return RawRows{plane.own.kept.in_order(metres)};
}

}  // namespace

const NetcdfVariable* find_bathymetry(const NetcdfFile& file, bool any_plane) {
  const NetcdfVariable* only_plane = nullptr;
  const NetcdfVariable* extreme = nullptr;
  std::size_t planes = 0;
  for (const NetcdfVariable& variable : file.variables()) {
    const Statistic statistic = statistic_of(variable);
    if (statistic != Statistic::none && !is_extreme(statistic)) continue;
    const bool plane = is_plane(variable);
    if ((plane || unsupported_grid(file, variable)) && is_called_bathymetry(variable)) {
      if (statistic == Statistic::none) return &variable;
      if (extreme == nullptr) extreme = &variable;
    }
    if (!plane) continue;
    only_plane = &variable;
    ++planes;
  }
  if (extreme != nullptr) return extreme;
  return any_plane && planes == 1 ? only_plane : nullptr;
}

Checked<PreparedDataset> read_netcdf_bathymetry(std::shared_ptr<const NetcdfFile> file,
                                                const IngestOptions& options) {
  const NetcdfVariable* variable = find_bathymetry(*file, options.kind.has_value());
  if (variable == nullptr) return refuse(messages::ingest_depth_message<"depths-not-found">());
  auto place = place_of(file, *variable, options.crs);
  if (!place) return refuse(place.error());
  std::optional<BentPlane>& bent = place->bent;

  const std::string unit = variable->attribute("units");
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor)
    return refuse(messages::ingest_depth_message<"depth-unit-unknown">(
        "the variable \"" + variable->name() + "\" has", unit));

  RawBathymetry raw{.grid = std::move(place->grid),
                    .description = {.name = variable->name(),
                                    .standard_name = variable->attribute("standard_name"),
                                    .long_name = variable->attribute("long_name"),
                                    .positive = variable->attribute("positive")},
                    .warnings = place->layout.warnings,
                    .read = {}};
  if (unit.empty())
    raw.warnings.push_back(messages::ingest_depth_message<"depth-without-unit">(variable->name()));
  if (const Statistic statistic = statistic_of(*variable); statistic != Statistic::none)
    raw.warnings.push_back(
        messages::ingest_depth_message<"depth-of-a-statistic">(variable->name(), in_words(statistic)));
  if (bent) {
    auto rows = rows_of_bent(*variable, *bent, *factor);
    if (!rows) return refuse(rows.error());
    raw.warnings.push_back(messages::ingest_depth_message<"depths-kept-at-own-points">(
        bent->own.kept.mesh.points.size(), std::string{"a bent grid"}));
    raw.read = rows_in_memory(std::move(*rows), 1);
    raw.own_points = std::move(bent->own.kept);
    return prepare_bathymetry(std::move(raw), options.positive);
  }
  raw.read = [file = std::move(file), variable, layout = std::move(place->layout), factor = *factor](
                 std::size_t first_row, std::size_t count) -> Checked<RawRows> {
    const auto values = read_rows(*variable, layout, 0, 0, first_row, count);
    if (!values) return refuse(values.error());
    RawRows rows;
    rows.values_m.reserve(values->size());
    for (const double value : *values) rows.values_m.push_back(static_cast<float>(value * factor));
    return rows;
  };
  return prepare_bathymetry(std::move(raw), options.positive);
}

}  // namespace floeplan::ingest
