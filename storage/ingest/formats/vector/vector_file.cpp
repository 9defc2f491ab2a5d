#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <string_view>

#include "engine/messages/ingest_feature_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/foreign_database.hpp"

namespace floeplan::ingest {

namespace {

/// Reads all features once. Where a feature cannot be read, GDAL ends the layer early; only its error state
/// shows that.
Checked<void> every_feature_can_be_read(GDALDataset& dataset) {
  CPLErrorReset();
  for (OGRLayer* const layer : dataset.GetLayers()) {
    layer->ResetReading();
    for (const auto& feature : *layer) {
      static_cast<void>(feature);
      // GDAL returns the feature without the attribute; a zone's rule could lose its period without notice.
      if (std::string_view{CPLGetLastErrorMsg()}.starts_with("Invalid content for record"))
        return refuse(messages::ingest_feature_message<"table-value-too-long">(CPLGetLastErrorMsg()));
    }
    if (CPLGetLastErrorType() >= CE_Failure)
      return refuse(messages::ingest_feature_message<"features-unreadable">(CPLGetLastErrorMsg()));
    layer->ResetReading();
  }
  return {};
}

bool is_raster(const std::string& path, const char* const* drivers, const char* const* options) {
  const GdalMessages messages;
  return GDALDatasetUniquePtr{GDALDataset::Open(path.c_str(), GDAL_OF_RASTER, drivers, options)} != nullptr;
}

/// Checks the schema of a GeoPackage before GDAL opens it, because a schema can call GDAL's functions.
Checked<void> holds_plain_tables(const std::filesystem::path& file) {
  try {
    const auto part = sql::active_part_of(file);
    if (!part) return {};
    return refuse(messages::ingest_feature_message<"geopackage-with-code">(*part));
  } catch (const sql::Failure& failure) {
    return refuse(messages::ingest_feature_message<"geopackage-unreadable">(failure.what()));
  }
}

}  // namespace

bool is_geopackage(std::string_view head) {
  constexpr std::size_t id_offset = 68;
  return head.starts_with("SQLite format 3") && head.size() > id_offset + 4 &&
         head.substr(id_offset, 2) == "GP";
}

Checked<std::shared_ptr<GDALDataset>> open_vector_file(const std::filesystem::path& file,
                                                       const char* driver) {
  register_drivers();
  const GdalMessages messages;
  const char* const drivers[] = {driver, nullptr};
  const bool is_database = std::string_view{driver} == "GPKG";
  if (is_database)
    if (const auto plain = holds_plain_tables(file); !plain) return refuse(plain.error());
  const char* const immutable[] = {"IMMUTABLE=YES", nullptr};
  const char* const* const options = is_database ? immutable : nullptr;
  const std::string path = std::filesystem::absolute(file).string();
  std::shared_ptr<GDALDataset> dataset{
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options)};
  if (!dataset && is_raster(path, drivers, options))
    return refuse(messages::ingest_feature_message<"geopackage-of-tiles">());
  if (!dataset)
    return refuse(messages::ingest_feature_message<"vector-file-unreadable">(messages.first_error()));
  GIntBig features = 0;
  for (OGRLayer* const layer : dataset->GetLayers()) features += layer->GetFeatureCount();
  if (features == 0) return refuse(messages::ingest_feature_message<"features-missing">("file", "features"));
  if (const auto whole = every_feature_can_be_read(*dataset); !whole) return refuse(whole.error());
  return dataset;
}

std::vector<std::filesystem::path> parts_of_shapefile(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> parts{file};
  for (const char* const ending : {".dbf", ".prj", ".cpg", ".DBF", ".PRJ", ".CPG"}) {
    std::filesystem::path part = file;
    part.replace_extension(ending);
    if (std::filesystem::is_regular_file(part)) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace floeplan::ingest
