#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/grids/own_points.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/places_by_crs.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_grid.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"
#include "storage/ingest/readers/bathymetry/depth_table.hpp"
#include "storage/ingest/readers/bathymetry/raster_crs.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::int64_t max_nodes = 4'000'000'000;  // GEBCO's grid has 3.7e9
/// Most nodes that are kept at places of their own. Their mesh is made in memory by the reading process, which has
/// 480 MB and 5 s for a small file: a node takes about 120 bytes and 1.7 us.
constexpr std::int64_t max_own_places = 2'000'000;

bool is_picture(GDALDataset& dataset) {
  GDALRasterBand* band = dataset.GetRasterBand(1);
  const GDALColorInterp colour = band->GetColorInterpretation();
  return band->GetColorTable() != nullptr || colour == GCI_PaletteIndex || colour == GCI_RedBand;
}

/// Number of the band to read: the first described as depths or elevations; else the first that is not a
/// statistic; else 1.
int depth_band(GDALDataset& dataset) {
  int first = 0;
  for (int i = 1; i <= dataset.GetRasterCount(); ++i) {
    const std::string description = dataset.GetRasterBand(i)->GetDescription();
    if (statistic_in_words(description) != Statistic::none) continue;
    if (contains_any(lower(description), {"elevation", "depth", "bathymetr"})) return i;
    if (first == 0) first = i;
  }
  return std::max(first, 1);
}

using DatasetPtr = std::unique_ptr<GDALDataset>;

/// One band of a raster with the unit of its numbers.
struct Plane {
  GDALRasterBand* band{};  // borrowed
  double unit_m{};
};

/// Rows and columns of a raster in the order in which its values are used.
struct Order {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> columns;
};

Checked<std::vector<float>> read_plane(const Plane& plane, const Order& order, std::size_t first_row,
                                       std::size_t rows) {
  GDALRasterBand& band = *plane.band;
  int has_nodata = 0;
  double nodata = band.GetNoDataValue(&has_nodata);
  if (band.GetRasterDataType() == GDT_Float32) nodata = static_cast<double>(static_cast<float>(nodata));
  int given = 0;
  double scale = band.GetScale(&given);
  if (given == 0 || scale == 0.0) scale = 1.0;
  double offset = band.GetOffset(&given);
  if (given == 0) offset = 0.0;

  std::vector<double> line(static_cast<std::size_t>(band.GetXSize()));
  std::vector<float> values;
  values.reserve(order.columns.size() * rows);
  const GdalMessages messages;
  for (const std::size_t row : std::span{order.rows}.subspan(first_row, rows)) {
    if (band.RasterIO(GF_Read, 0, static_cast<int>(row), band.GetXSize(), 1, line.data(), band.GetXSize(), 1,
                      GDT_Float64, 0, 0, nullptr) != CE_None)
      return refuse(messages::ingest_depth_message<"grid-not-read-to-its-end">(messages.first_error()));
    for (const std::size_t column : order.columns) {
      const double packed = line[column];
      const bool is_missing = !std::isfinite(packed) || (has_nodata != 0 && packed == nodata);
      values.push_back(is_missing ? std::numeric_limits<float>::quiet_NaN()
                                  : static_cast<float>((packed * scale + offset) * plane.unit_m));
    }
  }
  return values;
}

Checked<Plane> plane_of(GDALDataset& dataset, int band_number) {
  GDALRasterBand* band = dataset.GetRasterBand(band_number);
  const std::string unit = band->GetUnitType();
  const auto factor = unit.empty() ? std::optional{1.0} : length_factor(unit);
  if (!factor) return refuse(messages::ingest_depth_message<"depth-unit-unknown">("the depths have", unit));
  return Plane{band, *factor};
}

/// A raster and, if a cell combines several measurements, rasters of the lowest and the highest of them.
struct Views {
  DatasetPtr middle;
  DatasetPtr lowest;   // null: one measurement per cell
  DatasetPtr highest;  // null: one measurement per cell
};

DatasetPtr open_raster(const std::filesystem::path& file, const char* driver,
                       const char* const* options = nullptr) {
  const char* const drivers[] = {driver, nullptr};
  return DatasetPtr{GDALDataset::Open(std::filesystem::absolute(file).c_str(),
                                      GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, drivers, options)};
}

/// Opens a BAG of variable resolution on one grid with its finest spacing; GDAL's default view has the
/// coarsest spacing.
DatasetPtr open_finest(const std::filesystem::path& file, const char* population) {
  const char* const options[] = {"MODE=RESAMPLED_GRID", population, nullptr};
  return open_raster(file, "BAG", options);
}

bool is_larger_than(GDALDataset& dataset, std::int64_t most) {
  return std::int64_t{dataset.GetRasterXSize()} * dataset.GetRasterYSize() > most;
}

messages::Message larger_than_accepted(GDALDataset& dataset) {
  return messages::ingest_depth_message<"depth-grid-too-large">(dataset.GetRasterXSize(),
                                                                dataset.GetRasterYSize(), max_nodes);
}

Checked<Views> open_views(const std::filesystem::path& file, const char* driver) {
  const GdalMessages messages;
  Views views{open_raster(file, driver), nullptr, nullptr};
  const bool variable = views.middle && std::string_view{driver} == "BAG" &&
                        views.middle->GetMetadataItem("MAX_RESOLUTION_X") != nullptr;
  if (variable) {
    views.middle = open_finest(file, "VALUE_POPULATION=MEAN");
    if (views.middle && is_larger_than(*views.middle, max_nodes))
      return refuse(larger_than_accepted(*views.middle));
    views.lowest = open_finest(file, "VALUE_POPULATION=MIN");
    views.highest = open_finest(file, "VALUE_POPULATION=MAX");
  }
  if (!views.middle || views.middle->GetRasterCount() == 0 || (variable && (!views.lowest || !views.highest)))
    return refuse(messages::ingest_depth_message<"grid-not-opened">(messages.first_error()));
  if (is_larger_than(*views.middle, max_nodes)) return refuse(larger_than_accepted(*views.middle));
  return views;
}

/// Number of the band with the uncertainty of the depths, which BAG files and their conversions have; 0 if
/// there is none.
int uncertainty_band(GDALDataset& dataset) {
  for (int i = 1; i <= dataset.GetRasterCount(); ++i)
    if (contains_any(lower(dataset.GetRasterBand(i)->GetDescription()), {"uncertainty"})) return i;
  return 0;
}

/// The values, extremes and uncertainty of each cell, all on the same nodes.
struct Planes {
  Views views;  // rasters that own the planes' bands
  Plane middle;
  std::optional<Plane> lowest{};
  std::optional<Plane> highest{};
  std::optional<Plane> uncertainty{};
};

Checked<RawRows> read_planes(const Planes& planes, const Order& order, std::size_t first_row,
                             std::size_t count) {
  RawRows rows;
  auto values = read_plane(planes.middle, order, first_row, count);
  if (!values) return refuse(values.error());
  rows.values_m = std::move(*values);
  for (const auto& [plane, extremes] :
       {std::pair{&planes.lowest, &RawRows::lowest_m}, std::pair{&planes.highest, &RawRows::highest_m}}) {
    if (!*plane) continue;
    values = read_plane(**plane, order, first_row, count);
    if (!values) return refuse(values.error());
    rows.*extremes = std::move(*values);
  }
  if (!planes.uncertainty) return rows;
  values = read_plane(*planes.uncertainty, order, first_row, count);
  if (!values) return refuse(values.error());
  widen(rows, *values);
  return rows;
}

Checked<std::shared_ptr<const Planes>> planes_of(Views views) {
  const int band = depth_band(*views.middle);
  auto middle = plane_of(*views.middle, band);
  if (!middle) return refuse(middle.error());
  Planes planes{.views = std::move(views), .middle = std::move(*middle)};
  const auto add = [&](std::optional<Plane>& plane, GDALDataset* dataset, int number) -> Checked<bool> {
    if (dataset == nullptr) return true;
    auto found = plane_of(*dataset, number);
    if (!found) return refuse(found.error());
    plane = std::move(*found);
    return true;
  };
  if (auto added = add(planes.lowest, planes.views.lowest.get(), band); !added) return refuse(added.error());
  if (auto added = add(planes.highest, planes.views.highest.get(), band); !added)
    return refuse(added.error());
  const int uncertainty = uncertainty_band(*planes.views.middle);
  if (uncertainty != 0 && uncertainty != band) {
    if (auto added = add(planes.uncertainty, planes.views.middle.get(), uncertainty); !added)
      return refuse(added.error());
  }
  return std::make_shared<const Planes>(std::move(planes));
}

VerticalDescription description_of(const Plane& plane, std::string_view driver) {
  const std::string description = plane.band->GetDescription();
  const char* positive = plane.band->GetMetadataItem("positive");
  return {.name = description.empty() ? "band " + std::to_string(plane.band->GetBand()) : description,
          .standard_name = driver == "BAG" ? "height" : "",
          .long_name = "",
          .positive = positive == nullptr ? "" : positive};
}

/// Where the values of a raster lie.
struct PlacedRaster {
  Order order;
  ocean::HorizontalGrid grid;                            // of the nodes, or the one on which they are used
  std::optional<repository::MeshInBlocks> own_places{};  // empty: they are the grid's nodes
};

std::vector<double> centres(double origin, double step, int count) {
  std::vector<double> values;
  values.reserve(count);
  for (int i = 0; i < count; ++i) values.push_back(origin + step * (i + 0.5));
  return values;
}

/// Places the values on a kind of grid that the store has.
Checked<PlacedRaster> placed_on_axes(GDALDataset& dataset, const RasterTransform& t,
                                     const geo::GridFrame& frame) {
  const bool geographic = std::holds_alternative<geo::GeographicFrame>(frame);
  auto x_values = centres(t[0], t[1], dataset.GetRasterXSize());
  auto y_values = centres(t[3], t[5], dataset.GetRasterYSize());
  auto x = geographic ? longitude_nodes("longitude", std::move(x_values))
                      : monotonic_nodes("x", std::move(x_values));
  if (!x) return refuse(x.error());
  auto y = geographic ? latitude_nodes("latitude", std::move(y_values))
                      : monotonic_nodes("y", std::move(y_values));
  if (!y) return refuse(y.error());
  return PlacedRaster{{std::move(y->source), std::move(x->source)},
                      {frame, ocean::Axis{std::move(x->nodes)}, ocean::Axis{std::move(y->nodes)}}};
}

/// In a projection that the store has no grid for, or rotated: every pixel is kept at the place of its
/// centre, and plans interpolate between these places. A model on a bent grid is stored in the same way, so
/// the projection is not needed once the file is read.
Checked<PlacedRaster> placed_by_themselves(GDALDataset& dataset, const RasterTransform& t,
                                           const OGRSpatialReference& crs) {
  if (is_larger_than(dataset, max_own_places))
    return refuse(messages::ingest_depth_message<"depth-grid-too-large-to-convert">(
        dataset.GetRasterXSize(), dataset.GetRasterYSize(), std::string{crs.GetName()}, max_own_places));
  const auto rows = static_cast<std::size_t>(dataset.GetRasterYSize());
  const auto columns = static_cast<std::size_t>(dataset.GetRasterXSize());
  auto places = places_by_crs(crs, rows, columns, [&](std::size_t row, std::size_t column) {
    const double across = static_cast<double>(column) + 0.5;
    const double down = static_cast<double>(row) + 0.5;
    return geo::GridPoint{t[0] + t[1] * across + t[2] * down, t[3] + t[4] * across + t[5] * down};
  });
  if (!places) return refuse(messages::ingest_depth_message<"grid-not-convertible">(places.error()));
  auto own = own_points_of(std::move(*places), columns);
  if (!own) return refuse(own.error());
  Order order{std::vector<std::size_t>(rows), std::vector<std::size_t>(columns)};
  std::iota(order.rows.begin(), order.rows.end(), std::size_t{0});
  std::iota(order.columns.begin(), order.columns.end(), std::size_t{0});
  return PlacedRaster{std::move(order), std::move(own->grid), std::move(own->kept)};
}

Checked<PlacedRaster> placed_raster(GDALDataset& dataset, OGRSpatialReference crs) {
  RasterTransform t{};
  if (dataset.GetGeoTransform(t.data()) != CE_None)
    return refuse(messages::ingest_depth_message<"grid-without-position">());
  if (crs.IsProjected() != 0) {  // feet, for example
    const double unit_m = crs.GetLinearUnits();
    for (double& coefficient : t) coefficient *= unit_m;
    crs.SetLinearUnitsAndUpdateParameters(SRS_UL_METER, 1.0);
  }
  const auto frame = grid_frame_of(crs);
  const bool is_rotated = t[2] != 0.0 || t[4] != 0.0;
  if (!frame || is_rotated) return placed_by_themselves(dataset, t, crs);
  auto placed = placed_on_axes(dataset, t, *frame);
  const bool geographic = std::holds_alternative<geo::GeographicFrame>(*frame);
  if (!placed || geographic || lies_in_projection(placed->grid)) return placed;
  return placed_by_themselves(dataset, t, crs);
}

/// All values, in the order in which they are kept.
Checked<RawRows> read_own(const Planes& planes, const PlacedRaster& raster) {
  auto all = read_planes(planes, raster.order, 0, raster.order.rows.size());
  if (!all) return all;
  for (std::vector<float>* values : {&all->values_m, &all->lowest_m, &all->highest_m})
    if (!values->empty()) *values = raster.own_places->in_order(*values);
  return all;
}

Checked<PreparedDataset> prepared_raster(Views views, std::string_view driver, const IngestOptions& options) {
  if (is_picture(*views.middle)) return refuse(messages::ingest_depth_message<"grid-is-a-picture">());

  Messages warnings;
  const auto crs = crs_of_raster(*views.middle, driver, options, warnings);
  if (!crs) return refuse(crs.error());
  auto raster = placed_raster(*views.middle, *crs);
  if (!raster) return refuse(raster.error());
  const auto planes = planes_of(std::move(views));
  if (!planes) return refuse(planes.error());
  const Plane& middle = (*planes)->middle;
  const Statistic statistic = statistic_in_words(middle.band->GetDescription());
  if (statistic != Statistic::none && statistic != Statistic::minimum && statistic != Statistic::maximum)
    return refuse(messages::ingest_depth_message<"raster-of-other-values">(
        in_words(statistic), std::string{middle.band->GetDescription()}));

  RawBathymetry raw{.grid = raster->grid,
                    .description = description_of(middle, driver),
                    .warnings = std::move(warnings),
                    .read = {}};
  if (raster->own_places) {
    auto rows = read_own(**planes, *raster);
    if (!rows) return refuse(rows.error());
    raw.warnings.push_back(messages::ingest_depth_message<"depths-kept-at-own-points">(
        raster->own_places->mesh.points.size(), "a grid in \"" + std::string{crs->GetName()} + "\""));
    raw.read = rows_in_memory(std::move(*rows), 1);
    raw.own_points = std::move(raster->own_places);
  } else {
    raw.read = [planes = *planes, order = std::move(raster->order)](std::size_t first_row, std::size_t rows) {
      return read_planes(*planes, order, first_row, rows);
    };
  }
  return prepare_bathymetry(std::move(raw), options.positive);
}

}  // namespace

Checked<PreparedDataset> read_raster_bathymetry(const std::filesystem::path& file, const char* driver,
                                                const IngestOptions& options) {
  register_drivers();
  auto views = open_views(file, driver);
  if (!views) return refuse(views.error());
  return prepared_raster(std::move(*views), driver, options);
}

Checked<PreparedDataset> read_depth_table(const std::filesystem::path& file, const IngestOptions& options) {
  register_drivers();
  auto raster = open_depth_table(file);
  if (!raster) return refuse(raster.error());
  return prepared_raster(Views{std::move(*raster), nullptr, nullptr}, depth_table, options);
}

}  // namespace floeplan::ingest
