#include "storage/ingest/readers/ice/ice_raster.hpp"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/vector/polygon_shapes.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"

namespace floeplan::ingest {
namespace {

constexpr float without_bound = std::numeric_limits<float>::max();
constexpr double most_raster_nodes =
    // 16 MB for both quantities, and as much again while they are filled
    2'000'000.0;
constexpr double finest_spacing_m = 250.0;  // charts are drawn at 1:1 000 000 and coarser
// of an edge before projection; a shorter edge deviates by metres only
constexpr double longest_edge_deg = 0.1;

/// Square cells of a box, in metres of the projection.
struct Cells {
  double west_m{};  // west coordinate of the first node
  double south_m{};
  double spacing_m{};
  int columns{};
  int rows{};
};

Cells cells_over(const OGREnvelope& box) {
  const double width = box.MaxX - box.MinX;
  const double height = box.MaxY - box.MinY;
  const double spacing = std::max(finest_spacing_m, std::sqrt(width * height / most_raster_nodes));
  constexpr double around = 2.0;  // margin in cells, because values spread to neighbours
  return {box.MinX - around * spacing, box.MinY - around * spacing, spacing,
          static_cast<int>(std::ceil(width / spacing + 2.0 * around)) + 1,
          static_cast<int>(std::ceil(height / spacing + 2.0 * around)) + 1};
}

/// Releases a reference to a reference system that geometries share.
struct Uncount {
  void operator()(OGRSpatialReference* crs) const { crs->Release(); }
};
using SharedCrs = std::unique_ptr<OGRSpatialReference, Uncount>;

SharedCrs crs_of_epsg(int code) {
  SharedCrs crs{new OGRSpatialReference};
  crs->importFromEPSG(code);
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

/// Projects every polygon and returns the box around all of them.
Checked<OGREnvelope> project(std::vector<IcePolygon>& polygons, OGRSpatialReference& target) {
  OGREnvelope box;
  for (IcePolygon& polygon : polygons) {
    if (polygon.area->transformTo(&target) != OGRERR_NONE)
      return refuse(messages::ingest_ice_message<"ice-not-projectable">());
    OGREnvelope own;
    polygon.area->getEnvelope(&own);
    if (!std::isfinite(own.MinX + own.MaxX + own.MinY + own.MaxY))
      return refuse(messages::ingest_ice_message<"ice-not-projectable">());
    box.Merge(own);
  }
  return box;
}

/// Writes the polygons into cells in ascending order of their values, so that the greatest stays. NaN where
/// no polygon touches the cell.
std::vector<float> burn(const std::vector<IcePolygon>& polygons, const std::vector<float>& values,
                        const Cells& cells) {
  std::vector<std::size_t> order(polygons.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<OGRGeometryH> shapes;
  std::vector<double> burnt;
  for (const std::size_t i : order) {
    shapes.push_back(OGRGeometry::ToHandle(polygons[i].area.get()));
    burnt.push_back(static_cast<double>(values[i]));
  }
  register_drivers();
  const GDALDatasetUniquePtr raster{GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", cells.columns, cells.rows, 1, GDT_Float32, nullptr)};
  double transform[6] = {cells.west_m - 0.5 * cells.spacing_m,
                         cells.spacing_m,
                         0.0,
                         cells.south_m - 0.5 * cells.spacing_m,
                         0.0,
                         cells.spacing_m};
  raster->SetGeoTransform(transform);
  raster->GetRasterBand(1)->Fill(std::numeric_limits<double>::quiet_NaN());
  int band = 1;
  char all_touched[] = "ALL_TOUCHED=TRUE";
  char* options[] = {all_touched, nullptr};
  std::vector<float> result(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows));
  const bool done =
      GDALRasterizeGeometries(raster.get(), 1, &band, static_cast<int>(shapes.size()), shapes.data(), nullptr,
                              nullptr, burnt.data(), options, nullptr, nullptr) == CE_None &&
      raster->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, cells.columns, cells.rows, result.data(),
                                         cells.columns, cells.rows, GDT_Float32, 0, 0) == CE_None;
  if (!done) throw std::runtime_error{"polygons of ice cannot be laid on a grid"};
  return result;
}

/// The greatest value of each cell and its eight neighbours. A zero does not spread to cells without a value.
std::vector<float> spread(const std::vector<float>& values, const Cells& cells) {
  const int columns = cells.columns;
  const auto place = [columns](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  };
  std::vector<float> result = values;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      float& value = result[place(row, column)];
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, cells.rows - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns - 1); ++x) {
          const float near = values[place(y, x)];
          if (near > 0.0F && !(value >= near)) value = near;
        }
      }
    }
  }
  return result;
}

ocean::Axis nodes(double first, double step, int count) {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) all.push_back(first + step * i);
  return ocean::Axis{std::move(all)};
}

/// Assigns WGS84 to polygons without a reference system, and divides long edges in degrees, because
/// projecting bends them.
Checked<bool> prepare_polygons(std::vector<IcePolygon>& polygons) {
  bool north = false;
  bool south = false;
  const SharedCrs wgs84 = crs_of_epsg(4326);
  for (IcePolygon& polygon : polygons) {
    if (polygon.area->getSpatialReference() == nullptr) polygon.area->assignSpatialReference(wgs84.get());
    const OGRSpatialReference& crs = *polygon.area->getSpatialReference();
    if (crs.IsGeographic() != 0) remove_jumps(*polygon.area);
    polygon.area->segmentize(crs.IsGeographic() != 0 ? longest_edge_deg : 10'000.0 / crs.GetLinearUnits());
    const std::unique_ptr<OGRGeometry> degrees{polygon.area->clone()};
    OGREnvelope box;
    if (degrees->transformTo(wgs84.get()) != OGRERR_NONE)
      return refuse(messages::ingest_ice_message<"ice-corners-off-the-earth">());
    degrees->getEnvelope(&box);
    north = north || box.MaxY > 0.0;
    south = south || box.MinY < 0.0;
  }
  if (north && south) return refuse(messages::ingest_ice_message<"ice-on-both-hemispheres">());
  return north;
}

}  // namespace

Checked<IceRaster> lay_on_grid(std::vector<IcePolygon> polygons) {
  const auto north = prepare_polygons(polygons);
  if (!north) return refuse(north.error());
  const SharedCrs target = crs_of_epsg(*north ? 3413 : 3031);
  const auto box = project(polygons, *target);
  if (!box) return refuse(box.error());
  const Cells cells = cells_over(*box);

  std::vector<float> concentrations;
  std::vector<float> thicknesses_m;
  for (const IcePolygon& polygon : polygons) {
    concentrations.push_back(static_cast<float>(polygon.ice.concentration));
    thicknesses_m.push_back(polygon.ice.thickness_m ? static_cast<float>(*polygon.ice.thickness_m)
                                                    : without_bound);
  }
  IceRaster raster{{grid_frame_of(*target).value(), nodes(cells.west_m, cells.spacing_m, cells.columns),
                    nodes(cells.south_m, cells.spacing_m, cells.rows)},
                   spread(burn(polygons, concentrations, cells), cells),
                   spread(burn(polygons, thicknesses_m, cells), cells)};
  std::ranges::replace(raster.thickness_m, without_bound, missing);
  return raster;
}

}  // namespace floeplan::ingest
