#include "storage/ingest/coastline_geojson_reader.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "engine/geo/polygon.hpp"
#include "storage/ingest/polygon_shapes.hpp"
#include "storage/repository/coastline_repository.hpp"

namespace floeplan::ingest {
Checked<PreparedDataset> read_geojson_coastline(GDALDataset& dataset) {
  OGRLayer& layer = *dataset.GetLayer(0);
  std::vector<geo::Polygon> land;
  const PolygonShapes shapes;
  int number_of_feature = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    ++number_of_feature;
    auto polygons = shapes.polygons(feature->GetGeometryRef());
    if (!polygons)
      return refuse("feature " + std::to_string(number_of_feature) +
                    " cannot be used as land: " + polygons.error() +
                    "; land must not go missing, so nothing was stored; correct the file and try again");
    land.insert(land.end(), polygons->begin(), polygons->end());
  }

  std::vector<geo::LonLat> corners;
  for (const geo::Polygon& polygon : land)
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
  PreparedDataset data;
  data.kind = repository::DatasetKind::coastline;
  data.variables = {"land"};
  data.bounds = geo::bounding_box(corners);
  data.rows_accepted = static_cast<std::int64_t>(land.size());
  data.write = [land = std::move(land)](sqlite::Connection& db,
                                        const repository::DatasetId& id) -> tl::expected<void, std::string> {
    repository::CoastlineRepository{db}.insert(id, land);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
