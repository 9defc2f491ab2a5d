#include "storage/ingest/geojson_file.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "storage/ingest/gdal_guard.hpp"
#include "storage/ingest/grid_frame_of_crs.hpp"
#include "storage/ingest/zone_attributes.hpp"

namespace floeplan::ingest {

Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file) {
  register_drivers();
  const GdalMessages messages;
  const char* const drivers[] = {"GeoJSON", nullptr};
  const char* const options[] = {"DATE_AS_STRING=YES", nullptr};  // times are parsed where a zone is demanded
  const std::string path = std::filesystem::absolute(file).string();
  std::shared_ptr<GDALDataset> dataset{
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options)};
  if (!dataset || dataset->GetLayerCount() == 0)
    return refuse("the GeoJSON file cannot be read (" + messages.first_error() +
                  "); it is damaged or was cut short; copy or download it again");

  OGRLayer& layer = *dataset->GetLayer(0);
  if (layer.GetFeatureCount() == 0)
    return refuse("the GeoJSON file holds no features; there is nothing to store; check what you exported");
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  const auto frame =
      crs == nullptr ? std::optional<geo::GridFrame>{geo::GeographicFrame{}} : grid_frame_of(*crs);
  if (!frame || !std::holds_alternative<geo::GeographicFrame>(*frame))
    return refuse(std::string{"the GeoJSON file uses the coordinate reference system \""} + crs->GetName() +
                  "\"; GeoJSON is longitude and latitude on WGS84; export it again in EPSG:4326");
  return dataset;
}

Checked<repository::DatasetKind> kind_of_geojson(GDALDataset& dataset,
                                                 std::optional<repository::DatasetKind> wanted) {
  using repository::DatasetKind;
  if (wanted == DatasetKind::zones)
    return DatasetKind::zones;  // whose reader names each feature that is none
  bool points = false;
  bool polygons = false;
  bool others = false;
  bool rules = false;
  for (const auto& feature : *dataset.GetLayer(0)) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr) continue;
    const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbPoint) {
      points = true;
    } else if (type == wkbPolygon || type == wkbMultiPolygon) {
      polygons = true;
      rules = rules || states_zone_kind(*feature);
    } else {
      others = true;
    }
  }
  dataset.GetLayer(0)->ResetReading();
  if (points == polygons || others)
    return refuse(
        "the GeoJSON file holds neither only points (icebergs) nor only polygons (land, zones); what it "
        "means is "
        "unknown; put each kind into a file of its own");
  if (points) return DatasetKind::icebergs;
  return rules && wanted != DatasetKind::coastline ? DatasetKind::zones : DatasetKind::coastline;
}

}  // namespace floeplan::ingest
