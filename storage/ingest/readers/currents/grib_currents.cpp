#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_grib_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/grib/grib_grid.hpp"
#include "storage/ingest/formats/grib/grib_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/grids/row_mesh.hpp"
#include "storage/ingest/grids/true_north.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"
#include "storage/ingest/readers/currents/grib_contents.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

constexpr double fill_from = 9990.0;  // GDAL writes 9999 where a bitmap has no value

/// Positions of the values of a raster.
struct RasterPlace {
  std::vector<geo::LonLat> places;            // [row][column], rows in ascending order of the grid's y
  std::optional<ocean::HorizontalGrid> grid;  // empty: in a projection that the store has no grid for
  bool is_projected{false};
  GridDirections directions;         // directions of x at every node of a projection
  std::vector<std::size_t> columns;  // column numbers of the raster, in ascending order of x
  std::size_t rows{};
};

/// Transformation to longitude and latitude on the projection's own sphere or ellipsoid, as the producer
/// means them; null if there is none.
std::unique_ptr<OGRCoordinateTransformation> way_to_places(const OGRSpatialReference& plane) {
  OGRSpatialReference from{plane};
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference to;
  to.SetGeogCS("own", "own", "own", from.GetSemiMajor(), from.GetInvFlattening());
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return std::unique_ptr<OGRCoordinateTransformation>{OGRCreateCoordinateTransformation(&from, &to)};
}

/// Positions of the nodes of one row, moved along x by `shift`; not finite outside the range of the projection.
std::vector<geo::LonLat> places_along(OGRCoordinateTransformation& way, const std::vector<double>& x,
                                      double shift, double y) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> lons = x;
  for (double& lon : lons) lon += shift;
  std::vector<double> lats(x.size(), y);
  std::vector<int> reached(x.size(), 0);
  way.Transform(static_cast<int>(x.size()), lons.data(), lats.data(), nullptr, reached.data());
  std::vector<geo::LonLat> places;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool known = reached[i] != 0 && std::isfinite(lons[i]) && std::abs(lats[i]) <= 90.0;
    places.push_back(known ? geo::LonLat{geo::wrap_longitude(lons[i]), lats[i]}
                           : geo::LonLat{nowhere, nowhere});
  }
  return places;
}

Checked<RasterPlace> raster_place(const GribGrid& grid) {
  RasterPlace place;
  place.rows = grid.y.size();
  if (grid.plane == nullptr) {
    const auto lons = longitude_nodes("longitude", grid.x);
    if (!lons) return refuse(lons.error());
    const auto lats = latitude_nodes("latitude", grid.y);
    if (!lats) return refuse(lats.error());
    place.columns = lons->source;
    place.grid =
        ocean::HorizontalGrid{geo::GeographicFrame{}, ocean::Axis{lons->nodes}, ocean::Axis{lats->nodes}};
    for (const double lat : lats->nodes)
      for (const double lon : lons->nodes) place.places.push_back({lon, lat});
    return place;
  }
  const auto way = way_to_places(*grid.plane);
  if (!way) return refuse(messages::ingest_grib_message<"grib-projection-unusable">());
  place.is_projected = true;
  if (const auto frame = grid_frame_of(*grid.plane)) {
    ocean::HorizontalGrid nodes{*frame, ocean::Axis{grid.x}, ocean::Axis{grid.y}};
    if (lies_in_projection(nodes)) place.grid = std::move(nodes);
  }
  const std::size_t width = grid.x.size();
  const double ahead = width > 1 ? 1e-3 * (grid.x[1] - grid.x[0]) : 1.0;
  for (std::size_t i = 0; i < width; ++i) place.columns.push_back(i);
  for (const double y : grid.y) {
    const std::vector<geo::LonLat> here = places_along(*way, grid.x, 0.0, y);
    const std::vector<geo::LonLat> before = places_along(*way, grid.x, -ahead, y);
    const std::vector<geo::LonLat> after = places_along(*way, grid.x, ahead, y);
    place.places.insert(place.places.end(), here.begin(), here.end());
    for (std::size_t i = 0; i < width; ++i)
      place.directions.add(geo::direction_at(here[i], before[i], after[i]));
  }
  return place;
}

/// Opens the file as a raster. GDAL reorders every scanning mode to rows from north to south and columns from
/// west to east. The first column stays the grid's westernmost one, whatever its longitude.
std::shared_ptr<GDALDataset> open_in_rows(const std::filesystem::path& file) {
  const CPLConfigOptionSetter as_they_lie{"GRIB_ADJUST_LONGITUDE_RANGE", "NO", false};
  const char* const drivers[] = {"GRIB", nullptr};
  return std::shared_ptr<GDALDataset>{GDALDataset::Open(std::filesystem::absolute(file).c_str(),
                                                        GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers)};
}

class GribSource : public VelocitySource {
 public:
  GribSource(std::shared_ptr<GDALDataset> raster, GribContents contents, RasterPlace place,
             std::optional<GridDirections> directions)
      : raster_{std::move(raster)},
        contents_{std::move(contents)},
        place_{std::move(place)},
        directions_{std::move(directions)} {
    shape_.columns = place_.columns.size();
    shape_.rows = place_.rows;
    shape_.times_s = contents_.times_s;
    if (contents_.has_depths) shape_.depths_m = contents_.depths_m;
    shape_.levels = contents_.depths_m.size();
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return place_.places[point]; }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const override {
    const GribBands bands = contents_.bands[time * contents_.depths_m.size() + level];
    auto first = read_band(bands.east);
    if (!first) return refuse(first.error());
    auto second = read_band(bands.north);
    if (!second) return refuse(second.error());
    VelocitySlice slice{std::move(*first), std::move(*second), 0};
    for (std::size_t i = 0; i < slice.east.size(); ++i) {
      const float u = slice.east[i];
      const float v = slice.north[i];
      if (std::isnan(u) || std::isnan(v)) {
        slice.east[i] = slice.north[i] = missing;
      } else if (directions_) {
        const EastNorth current = to_true_north(u, v, *directions_, i);
        slice.east[i] = current.east;
        slice.north[i] = current.north;
      }
    }
    return slice;
  }

  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t /*time*/,
                                                         std::size_t /*level*/) const override {
    return refuse(messages::ingest_current_message<"levels-not-of-the-bed">("a GRIB file"));
  }

 private:
  /// The values of a band, rows from south to north and columns from west to east.
  [[nodiscard]] Checked<std::vector<float>> read_band(int number_of_band) const {
    const GdalMessages messages;
    const int width = raster_->GetRasterXSize();
    const int height = raster_->GetRasterYSize();
    GDALRasterBand* band = raster_->GetRasterBand(number_of_band);
    std::vector<double> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (band == nullptr || band->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height,
                                          GDT_Float64, 0, 0, nullptr) != CE_None)
      return refuse(messages::ingest_grib_message<"grib-field-unreadable">(messages.first_error()));
    int has_fill = 0;
    const double fill = band->GetNoDataValue(&has_fill);
    std::vector<float> result;
    result.reserve(shape_.points());
    for (std::size_t row = place_.rows; row-- > 0;) {
      for (const std::size_t column : place_.columns) {
        const double value = values[row * static_cast<std::size_t>(width) + column];
        const bool known =
            std::isfinite(value) && !(has_fill != 0 && value == fill) && std::abs(value) < fill_from;
        result.push_back(known ? static_cast<float>(value) : missing);
      }
    }
    return result;
  }

  std::shared_ptr<GDALDataset> raster_;
  GribContents contents_;
  RasterPlace place_;
  std::optional<GridDirections> directions_;
  SourceShape shape_;
};

Checked<PreparedDataset> read_velocities(const std::filesystem::path& file, Moving what,
                                         const core::ProgressCallback& progress) {
  const auto fields = grib_fields(file);
  if (!fields) return refuse(fields.error());
  auto contents = grib_contents(*fields, what);
  if (!contents) return refuse(contents.error());
  const std::optional<core::UtcTime> run = contents->run;
  const auto grid = grib_grid(contents->grid);
  if (!grid) return refuse(grid.error());

  register_drivers();
  const GdalMessages messages;
  std::shared_ptr<GDALDataset> raster = open_in_rows(file);
  if (!raster)
    return refuse(messages::ingest_file_message<"file-damaged">("GRIB file", messages.first_error()));
  if (static_cast<std::size_t>(raster->GetRasterCount()) != fields->size())
    return refuse(messages::ingest_grib_message<"grib-not-followed">(
        "its fields are not counted alike by two readers"));
  if (static_cast<std::size_t>(raster->GetRasterXSize()) != grid->x.size() ||
      static_cast<std::size_t>(raster->GetRasterYSize()) != grid->y.size())
    return refuse(
        messages::ingest_grib_message<"grib-not-followed">("two readers see grids of different size"));
  auto place = raster_place(*grid);
  if (!place) return refuse(place.error());

  CurrentInput input;
  input.what = what;
  input.variables = {"u", "v"};
  if (!contents->layers.empty())
    input.warnings.push_back(messages::ingest_grib_message<"grib-layers">(contents->layers));
  std::optional<GridDirections> directions;
  const bool is_projected = place->is_projected;
  if (contents->along_grid && is_projected) {
    directions = std::move(place->directions);
    input.warnings.push_back(messages::ingest_current_message<"turned-as-grib-says">(
        what == Moving::sea ? "the currents point" : "the wind points",
        number(directions->largest_turn_deg(), 3)));
  }
  if (place->grid) {
    input.grid = place->grid;
  } else {
    input.mesh = mesh_of_rows(place->places, place->columns.size());
    input.layout = "a projected grid";
  }
  input.source = std::make_shared<const GribSource>(std::move(raster), std::move(*contents),
                                                    std::move(*place), std::move(directions));
  auto data = prepare_currents(std::move(input), progress);
  if (!data) return data;
  data->run = run;
  // Older versions kept no projected grid of a GRIB file as such.
  if (is_projected && data->keeping == Keeping::on_a_grid) data->keeping = Keeping::on_a_projected_grid;
  return data;
}

}  // namespace

Checked<PreparedDataset> read_grib_currents(const std::filesystem::path& file,
                                            const core::ProgressCallback& progress) {
  return read_velocities(file, Moving::sea, progress);
}

Checked<PreparedDataset> read_grib_wind(const std::filesystem::path& file,
                                        const core::ProgressCallback& progress) {
  return read_velocities(file, Moving::air, progress);
}

}  // namespace floeplan::ingest
