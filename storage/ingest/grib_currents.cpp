#include "storage/ingest/grib_currents.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>

#include "storage/ingest/current_dataset.hpp"
#include "storage/ingest/gdal_guard.hpp"
#include "storage/ingest/grib_contents.hpp"
#include "storage/ingest/grib_messages.hpp"
#include "storage/ingest/grid_directions.hpp"
#include "storage/ingest/missing_value.hpp"
#include "storage/ingest/netcdf_axis.hpp"
#include "storage/ingest/text.hpp"
#include "storage/ingest/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

constexpr double fill_from = 9990.0;  // GDAL writes 9999 where a bitmap has no value
constexpr std::uint64_t max_points = 10'000'000;

/// Where the values of a raster lie.
struct RasterPlace {
  std::vector<geo::LonLat> places;            // [row][column], rows from south to north (by the grid's own y)
  std::optional<ocean::HorizontalGrid> grid;  // in longitude and latitude
  std::vector<std::size_t> columns;           // of the raster, in ascending order of x
  std::size_t rows{};
};

Checked<RasterPlace> place_of(GDALDataset& raster) {
  double at[6];
  const OGRSpatialReference* crs = raster.GetSpatialRef();
  if (crs == nullptr || raster.GetGeoTransform(at) != CE_None || at[2] != 0.0 || at[4] != 0.0 ||
      at[1] == 0.0 || at[5] == 0.0)
    return refuse("the grid of the GRIB file cannot be placed on the Earth; convert it to NetCDF first");
  const auto width = static_cast<std::size_t>(raster.GetRasterXSize());
  const auto height = static_cast<std::size_t>(raster.GetRasterYSize());
  if (width * height > max_points)
    return refuse("the grid of the GRIB file has " + std::to_string(width) + " x " + std::to_string(height) +
                  " nodes, more than this program accepts; cut out your area first");
  std::vector<double> x(width);
  std::vector<double> y(height);
  for (std::size_t i = 0; i < width; ++i) x[i] = at[0] + at[1] * (static_cast<double>(i) + 0.5);
  for (std::size_t j = 0; j < height; ++j) y[j] = at[3] + at[5] * (static_cast<double>(height - 1 - j) + 0.5);
  if (at[5] > 0.0 || at[1] < 0.0)
    return refuse(
        "the rows or columns of the GRIB file are turned round in a way that is not known; convert it to "
        "NetCDF first");

  RasterPlace place;
  place.rows = height;
  const bool plain = crs->IsGeographic() && !crs->IsDerivedGeographic();
  if (plain) {
    const auto lons = longitude_nodes("longitude", x);
    if (!lons) return refuse(lons.error());
    const auto lats = latitude_nodes("latitude", y);
    if (!lats) return refuse(lats.error());
    place.columns = lons->source;
    place.grid =
        ocean::HorizontalGrid{geo::GeographicFrame{}, ocean::Axis{lons->nodes}, ocean::Axis{lats->nodes}};
    for (const double lat : lats->nodes)
      for (const double lon : lons->nodes) place.places.push_back({lon, lat});
    return place;
  }
  // The coordinates of the projection's own sphere or ellipsoid, as the producer means them.
  OGRSpatialReference from{*crs};
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRSpatialReference> to{from.CloneGeogCS()};
  if (to) to->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation{
      to ? OGRCreateCoordinateTransformation(&from, to.get()) : nullptr};
  if (!transformation)
    return refuse(
        "the projection of the GRIB file cannot be used; convert it to latitude and longitude first");
  for (std::size_t i = 0; i < width; ++i) place.columns.push_back(i);
  for (const double row : y) {
    std::vector<double> lons = x;
    std::vector<double> lats(width, row);
    transformation->Transform(static_cast<int>(width), lons.data(), lats.data());
    for (std::size_t i = 0; i < width; ++i) place.places.push_back({geo::wrap_longitude(lons[i]), lats[i]});
  }
  return place;
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
        slice.east[i] = u * directions_->cosine[i] - v * directions_->sine[i];
        slice.north[i] = u * directions_->sine[i] + v * directions_->cosine[i];
      }
    }
    return slice;
  }

  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t /*time*/,
                                                         std::size_t /*level*/) const override {
    return refuse("the levels of a GRIB file do not follow the sea bed");
  }

 private:
  /// One band, rows from south to north and columns from west to east.
  [[nodiscard]] Checked<std::vector<float>> read_band(int number_of_band) const {
    const GdalMessages messages;
    const int width = raster_->GetRasterXSize();
    const int height = raster_->GetRasterYSize();
    GDALRasterBand* band = raster_->GetRasterBand(number_of_band);
    std::vector<double> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (band == nullptr || band->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height,
                                          GDT_Float64, 0, 0, nullptr) != CE_None)
      return refuse("a field of the GRIB file cannot be read (" + messages.first_error() +
                    "); the file is damaged; copy or download it again");
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

/// Of the nodes of a projected grid.
Checked<GridDirections> directions_on(const RasterPlace& place) {
  const Positions positions{place.places, place.rows, place.columns.size(), false};
  const Staggering collocated{.collocated = true,
                              .first_row = 0,
                              .second_column = 0,
                              .rows = positions.rows,
                              .columns = positions.columns};
  return directions_of(collocated, positions, positions, {}, {});
}

Checked<PreparedDataset> read_velocities(const std::filesystem::path& file, Moving what,
                                         const core::ProgressCallback& progress) {
  const auto fields = grib_fields(file);
  if (!fields) return refuse(fields.error());
  auto contents = grib_contents(*fields, what);
  if (!contents) return refuse(contents.error());
  const std::optional<core::UtcTime> run = contents->run;

  register_drivers();
  const GdalMessages messages;
  const char* const drivers[] = {"GRIB", nullptr};
  std::shared_ptr<GDALDataset> raster{GDALDataset::Open(std::filesystem::absolute(file).c_str(),
                                                        GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers)};
  if (!raster)
    return refuse("the GRIB file cannot be opened (" + messages.first_error() +
                  "); it is damaged or was cut short; copy or download it again");
  if (static_cast<std::size_t>(raster->GetRasterCount()) != fields->size())
    return refuse(
        "the GRIB file is built in a way that this program does not follow (its fields are not counted alike "
        "by two "
        "readers); convert it to NetCDF first");
  auto place = place_of(*raster);
  if (!place) return refuse(place.error());

  CurrentInput input;
  input.what = what;
  input.variables = {"u", "v"};
  std::optional<GridDirections> directions;
  if (contents->along_grid && !place->grid) {
    auto found = directions_on(*place);
    if (!found) return refuse(found.error());
    input.warnings.push_back(
        std::string{what == Moving::sea ? "the currents point" : "the wind points"} +
        " along the axes of the grid, as the file says; it was turned to east and north, by up to " +
        number(found->largest_turn_deg(), 3) + " degrees");
    directions = std::move(*found);
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
  if (data) data->run = run;
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
