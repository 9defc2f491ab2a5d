#include "storage/ingest/formats/netcdf/netcdf_projection.hpp"

#include <ogr_spatialref.h>

#include <array>
#include <cmath>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/notation/crs_text.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/places_by_crs.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// Removes AXIS elements of unknown direction. GDAL before version 3 wrote them for polar projections,
/// NSIDC's files contain them and PROJ refuses them. They are not needed: the coordinates of NetCDF state
/// their axis.
std::string without_unknown_axes(std::string wkt) {
  for (std::size_t at = wkt.find(",AXIS["); at != std::string::npos; at = wkt.find(",AXIS[", at)) {
    const std::size_t end = wkt.find(']', at);
    if (end == std::string::npos) return wkt;
    if (wkt.substr(at, end - at).ends_with("UNKNOWN"))
      wkt.erase(at, end + 1 - at);
    else
      at = end;
  }
  return wkt;
}

std::shared_ptr<OGRSpatialReference> crs_of_text(const std::string& text) {
  auto crs = std::make_shared<OGRSpatialReference>();
  if (!read_crs(text, *crs)) return nullptr;
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

bool has_any(const NetcdfVariable& variable, std::initializer_list<const char*> attributes) {
  for (const char* const name : attributes)
    if (!variable.attribute(name).empty()) return true;
  return false;
}

/// The reference system of a PROJ string beside the CF attributes, if those do not state the figure of the
/// Earth. GDAL then assumes WGS84, but the PROJ string may name a sphere, on which the grid lies up to 20 km
/// elsewhere.
std::shared_ptr<OGRSpatialReference> crs_with_stated_figure(const NetcdfVariable& mapping) {
  if (has_any(mapping, {"crs_wkt", "spatial_ref", "semi_major_axis", "semi_minor_axis", "inverse_flattening",
                        "earth_radius", "reference_ellipsoid_name", "horizontal_datum_name"}))
    return nullptr;
  for (const char* const name : {"proj4", "proj4_string", "proj4text", "proj4_params", "proj_string"}) {
    std::string proj = mapping.attribute(name);
    if (proj.find("+proj=") == std::string::npos) continue;
    // Metres, because the axes are converted to metres by their own unit.
    if (const std::size_t at = proj.find("+units=km"); at != std::string::npos)
      proj.replace(at, 9, "+units=m");
    if (auto crs = crs_of_text(proj); crs && crs->IsProjected() != 0) return crs;
  }
  return nullptr;
}

/// The variable in grid_mapping: "crs", or "crs: x y" of CF 1.7, where the coordinates of the mapping follow
/// its name.
const NetcdfVariable* mapping_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  const std::string text = variable.attribute("grid_mapping");
  const std::string name = text.substr(0, text.find_first_of(": "));
  return name.empty() ? nullptr : file.find(name);
}

/// Longitudes and latitudes around a rotated pole. They are rotated on a sphere, whatever figure of the Earth
/// the file states: the radius does not matter.
/// Source  CF conventions 1.8, appendix F, rotated_latitude_longitude
std::shared_ptr<OGRSpatialReference> turned_pole(const NetcdfVariable& mapping) {
  if (mapping.attribute("grid_mapping_name") != "rotated_latitude_longitude") return nullptr;
  const auto lat = mapping.numeric_attribute("grid_north_pole_latitude");
  const auto lon = mapping.numeric_attribute("grid_north_pole_longitude");
  if (!lat || !lon || std::abs(*lat) > 90.0) return nullptr;
  auto crs = std::make_shared<OGRSpatialReference>();
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  crs->SetGeogCS("own", "own", "own", 6371229.0, 0.0);
  const double meridian = mapping.numeric_attribute("north_pole_grid_longitude").value_or(0.0);
  const GdalMessages messages;
  const bool made = crs->SetDerivedGeogCRSWithPoleRotationNetCDFCFConvention("turned pole", *lat, *lon,
                                                                             meridian) == OGRERR_NONE;
  return made ? crs : nullptr;
}

struct Axes {
  const NetcdfVariable* y{nullptr};
  const NetcdfVariable* x{nullptr};
  bool turned{false};  // true: degrees around a rotated pole
};

std::optional<Axes> axes_of(const NetcdfFile& file, const NetcdfVariable& variable, std::size_t y_dimension,
                            std::size_t x_dimension) {
  Axes axes{coordinate_of(file, variable.dimensions()[y_dimension]),
            coordinate_of(file, variable.dimensions()[x_dimension]), false};
  if (axes.y == nullptr || axes.x == nullptr) return std::nullopt;
  axes.turned = axes.y->attribute("standard_name") == "grid_latitude" &&
                axes.x->attribute("standard_name") == "grid_longitude";
  const bool projected =
      role_of(*axes.y) == AxisRole::projected_y && role_of(*axes.x) == AxisRole::projected_x;
  return axes.turned || projected ? std::optional{axes} : std::nullopt;
}

/// Coordinate values in the order of the file.
Checked<std::vector<double>> values_of(const NetcdfVariable& coordinate, bool turned) {
  if (turned) return coordinate.read_all();
  Messages warnings;
  const auto nodes = projected_nodes(coordinate, warnings);
  if (!nodes) return refuse(nodes.error());
  std::vector<double> values(nodes->nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[nodes->source[i]] = nodes->nodes[i];
  return values;
}

}  // namespace

std::shared_ptr<const OGRSpatialReference> projection_of(const NetcdfFile& file,
                                                         const NetcdfVariable& variable) {
  const NetcdfVariable* const mapping = mapping_of(file, variable);
  if (mapping != nullptr) {
    if (auto crs = turned_pole(*mapping)) return crs;
    if (auto crs = crs_with_stated_figure(*mapping)) return crs;
  }
  if (auto crs = variable.crs()) return crs;
  if (mapping == nullptr) return nullptr;
  for (const char* const name : {"crs_wkt", "spatial_ref"}) {
    const std::string text = mapping->attribute(name);
    if (text.empty()) continue;
    if (auto crs = crs_of_text(without_unknown_axes(text))) return crs;
  }
  return nullptr;
}

bool is_placed_by_projection(const NetcdfFile& file, const NetcdfVariable& variable, std::size_t y_dimension,
                             std::size_t x_dimension) {
  const auto axes = axes_of(file, variable, y_dimension, x_dimension);
  if (!axes) return false;
  const auto crs = projection_of(file, variable);
  if (!crs || !earth_of(*crs)) return false;
  if (axes->turned) return crs->IsDerivedGeographic() != 0;
  if (crs->IsProjected() == 0 || std::abs(crs->GetLinearUnits() - 1.0) >= 1e-12) return false;
  const auto frame = grid_frame_of(*crs);
  if (!frame) return true;
  Messages warnings;
  const auto x = projected_nodes(*axes->x, warnings);
  const auto y = projected_nodes(*axes->y, warnings);
  return x && y && !lies_in_projection({*frame, ocean::Axis{x->nodes}, ocean::Axis{y->nodes}});
}

Checked<std::vector<geo::LonLat>> places_by_projection(const NetcdfFile& file, const NetcdfVariable& variable,
                                                       std::size_t y_dimension, std::size_t x_dimension) {
  const auto axes = axes_of(file, variable, y_dimension, x_dimension).value();
  const auto ys = values_of(*axes.y, axes.turned);
  if (!ys) return refuse(ys.error());
  const auto xs = values_of(*axes.x, axes.turned);
  if (!xs) return refuse(xs.error());
  if (ys->size() > max_grid_points / std::max<std::size_t>(1, xs->size()))
    return refuse(messages::ingest_netcdf_message<"too-many-nodes">("the grid of \"" + variable.name() + "\"",
                                                                    ys->size(), xs->size(), max_grid_points));

  auto places = places_by_crs(
      *projection_of(file, variable), ys->size(), xs->size(),
      [&](std::size_t row, std::size_t column) { return geo::GridPoint{(*xs)[column], (*ys)[row]}; });
  if (!places)
    return refuse(messages::ingest_netcdf_message<"projection-unusable">(variable.name(), places.error()));
  return std::move(*places);
}

}  // namespace floeplan::ingest
