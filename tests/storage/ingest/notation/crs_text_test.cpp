#include "storage/ingest/notation/crs_text.hpp"

#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "storage/ingest/common/gdal_guard.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"
#include "tests/support/loopback_listener.hpp"

namespace floeplan::ingest::crs_text_test {
namespace {

TEST(CrsText, IsWhatFilesAndUsersWrite) {
  for (const char* const text :
       {"EPSG:4326", "epsg:3413", " EPSG:3031\n", "ESRI:102018", "OGC:CRS84", "EPSG:4326+5773", "WGS84",
        "urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::3413",
        "http://www.opengis.net/def/crs/EPSG/0/4326", "https://www.opengis.net/def/crs/OGC/1.3/CRS84",
        "NAD83",
        "+proj=stere +lat_0=90 +lat_ts=70 +lon_0=-45 +k=1 +x_0=0 +y_0=0 +a=6378273 "
        "+b=6356889.449 +units=m +no_defs",
        "+proj=merc +a=6378137 +b=6378137 +lat_ts=0 +lon_0=0 +x_0=0 +y_0=0 +k=1 +units=m +nadgrids=@null "
        "+wktext "
        "+no_defs",
        "+proj=longlat +datum=WGS84 +type=crs", "+proj=utm +zone=22 +towgs84=0,0,0"}) {
    OGRSpatialReference crs;
    EXPECT_TRUE(read_crs(text, crs)) << text;
    EXPECT_FALSE(crs.IsEmpty()) << text;
  }
}

TEST(CrsText, IsReadBackFromEveryFormThatGdalWrites) {
  for (const int code : {4326, 3413, 3031, 3857, 32622, 3995, 5041, 4258}) {
    OGRSpatialReference one;
    ASSERT_EQ(one.importFromEPSG(code), OGRERR_NONE);
    for (const char* const format :
         {"FORMAT=WKT1_GDAL", "FORMAT=WKT1_ESRI", "FORMAT=WKT2_2015", "FORMAT=WKT2_2019"}) {
      const char* const options[] = {format, nullptr};
      char* wkt = nullptr;
      one.exportToWkt(&wkt, options);
      OGRSpatialReference other;
      EXPECT_TRUE(read_crs(wkt, other)) << wkt;
      CPLFree(wkt);
    }
    char* json = nullptr;
    one.exportToPROJJSON(&json, nullptr);
    OGRSpatialReference other;
    EXPECT_TRUE(read_crs(json, other) && other.IsSame(&one) != 0) << json;
    CPLFree(json);
  }
}

TEST(CrsText, IsNoPathAndNoAddress) {
  register_drivers();
  const support::LoopbackListener listener;
  for (const std::string& text : hostile_crs_texts("/etc/passwd", listener.port())) {
    OGRSpatialReference crs;
    EXPECT_FALSE(read_crs(text, crs)) << text;
    EXPECT_TRUE(crs.IsEmpty()) << text;
  }
  EXPECT_FALSE(listener.somebody_came());
}

TEST(CrsText, IsNotNothing) {
  OGRSpatialReference crs;
  for (const std::string& text :
       {std::string{}, std::string{"  "}, std::string{"GEOGCS["}, std::string{"{"}, std::string{"EPSG:"},
        std::string{"EPSG:4326\0x", 11}, std::string(100'000, 'a'), std::string{"../crs.wkt"},
        std::string{"+proj="}})
    EXPECT_FALSE(read_crs(text, crs)) << text.substr(0, 40);
}

}  // namespace
}  // namespace floeplan::ingest::crs_text_test
