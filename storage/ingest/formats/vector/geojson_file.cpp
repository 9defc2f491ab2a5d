#include "storage/ingest/formats/vector/geojson_file.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"

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

}  // namespace floeplan::ingest
