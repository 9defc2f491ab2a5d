#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "engine/messages/ingest_feature_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"

namespace floeplan::ingest {

Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file) {
  register_drivers();
  const GdalMessages messages;
  const char* const drivers[] = {"GeoJSON", nullptr};
  // as text, because GDAL would lose whether a time states its zone
  const char* const options[] = {"DATE_AS_STRING=YES", nullptr};
  const std::string path = std::filesystem::absolute(file).string();
  std::shared_ptr<GDALDataset> dataset{
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options)};
  if (!dataset || dataset->GetLayerCount() == 0)
    return refuse(messages::ingest_feature_message<"geojson-unreadable">(messages.first_error()));

  OGRLayer& layer = *dataset->GetLayer(0);
  if (layer.GetFeatureCount() == 0)
    return refuse(messages::ingest_feature_message<"features-missing">("GeoJSON file", "features"));
  const OGRSpatialReference* crs = layer.GetSpatialRef();
  const auto frame =
      crs == nullptr ? std::optional<geo::GridFrame>{geo::GeographicFrame{}} : grid_frame_of(*crs);
  if (!frame || !std::holds_alternative<geo::GeographicFrame>(*frame))
    return refuse(messages::ingest_feature_message<"geojson-in-other-crs">(std::string{crs->GetName()}));
  return dataset;
}

}  // namespace floeplan::ingest
