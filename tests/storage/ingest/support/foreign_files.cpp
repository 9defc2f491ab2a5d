#include "tests/storage/ingest/support/foreign_files.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::ingest {

std::vector<std::string> hostile_crs_texts(const std::filesystem::path& secret, int port) {
  const std::string server = "://127.0.0.1:" + std::to_string(port) + "/crs.wkt";
  const std::string file = secret.string();
  return {
      "http" + server,
      "https" + server,
      "/vsicurl/http" + server,
      "/vsicurl_streaming/http" + server,
      "/vsizip//vsicurl/http" + server,
      "/vsis3/bucket/crs.wkt",
      file,
      "/vsisubfile/0_100," + file,
      "/vsigzip/" + file,
      "DICT:" + file + ",1",
      "+init=" + file + ":1",
      "+proj=pipeline +step +proj=hgridshift +grids=" + file,
      "+proj=longlat +datum=WGS84 +nadgrids=" + file,
      "+proj=longlat +datum=WGS84 +nadgrids=@http" + server,
      "+proj=longlat +ellps=WGS84 +geoidgrids=" + file,
      R"(GEOGCS["x",DATUM["x",SPHEROID["x",6378137,298.257],EXTENSION["PROJ4_GRIDS",")" + file +
          R"("]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433],EXTENSION["PROJ4","+proj=longlat +nadgrids=)" +
          file + R"("]])",
      "urn:ogc:def:crs:http" + server};
}

void write_points(const char* driver, const std::filesystem::path& file,
                  const std::vector<std::string>& statements) {
  register_drivers();
  GDALDatasetUniquePtr vector{
      GetGDALDriverManager()->GetDriverByName(driver)->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer* layer = vector->CreateLayer("bergs", &wgs84, wkbPoint, nullptr);
  OGRFieldDefn id{"id", OFTString};
  OGRFieldDefn observed{"observed", OFTString};
  ASSERT_EQ(layer->CreateField(&id), OGRERR_NONE);
  ASSERT_EQ(layer->CreateField(&observed), OGRERR_NONE);
  for (int i = 0; i < 5; ++i) {
    OGRFeature feature{layer->GetLayerDefn()};
    feature.SetField("id", std::to_string(i).c_str());
    feature.SetField("observed", "2026-11-20T06:30:00Z");
    OGRPoint place{-50.0 - i, 60.0};
    feature.SetGeometry(&place);
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }
  vector->FlushCache();
  for (const std::string& statement : statements)
    vector->ReleaseResultSet(vector->ExecuteSQL(statement.c_str(), nullptr, nullptr));
}

}  // namespace floeplan::ingest
