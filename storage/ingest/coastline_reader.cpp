#include "storage/ingest/coastline_reader.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "engine/geo/polygon.hpp"
#include "storage/ingest/feature_kind.hpp"
#include "storage/ingest/polygon_shapes.hpp"
#include "storage/repository/coastline_repository.hpp"

namespace floeplan::ingest {
namespace {

struct Gathering {
  std::vector<geo::Polygon> land;
  bool shelves{false};
  bool others{false};
};

Checked<void> gather(Gathering& all, OGRLayer& layer, const IngestOptions& options) {
  const auto crs = crs_of(layer, options.crs);
  if (!crs) return refuse(crs.error());
  const auto shapes = PolygonShapes::in(*crs);
  if (!shapes) return refuse(shapes.error());
  int number_of_feature = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    ++number_of_feature;
    auto polygons = shapes->polygons(feature->GetGeometryRef());
    if (!polygons)
      return refuse("feature " + std::to_string(number_of_feature) +
                    " cannot be used as land: " + polygons.error() +
                    "; land must not go missing, so nothing was stored; correct the file and try again");
    all.land.insert(all.land.end(), polygons->begin(), polygons->end());
    (meaning_of(*feature) == PolygonMeaning::ice_shelf ? all.shelves : all.others) = true;
  }
  return {};
}

}  // namespace

Checked<PreparedDataset> read_coastline(GDALDataset& dataset, const IngestOptions& options) {
  Gathering all;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    if (layer->GetFeatureCount() == 0) continue;
    if (const auto gathered = gather(all, *layer, options); !gathered) return refuse(gathered.error());
  }

  std::vector<geo::LonLat> corners;
  for (const geo::Polygon& polygon : all.land)
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
  PreparedDataset data;
  data.kind = repository::DatasetKind::coastline;
  if (all.others) data.variables.emplace_back("land");
  if (all.shelves) data.variables.emplace_back(repository::ice_shelves_alone);
  if (all.shelves) data.warnings.emplace_back("ice shelves are stored as land: nothing passes below them");
  data.bounds = geo::bounding_box(corners);
  data.rows_accepted = static_cast<std::int64_t>(all.land.size());
  data.write = [land = std::move(all.land)](
                   sqlite::Connection& db,
                   const repository::DatasetId& id) -> tl::expected<void, std::string> {
    repository::CoastlineRepository{db}.insert(id, land);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
