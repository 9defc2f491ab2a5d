#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/readers/ice/chart_time.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::ice_chart_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr geo::BoundingBox around{-70.0, 60.0, -40.0, 75.0};

/// A polygon of a chart and its attributes.
struct Part {
  std::string wkt;
  std::vector<std::pair<std::string, std::string>> texts;
};

class IceCharts : public StoreFixture {
 protected:
  std::filesystem::path write(const std::string& name, const std::vector<Part>& parts, int epsg = 4326,
                              const char* driver_name = "ESRI Shapefile") const {
    register_writers();
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName(driver_name);
    const GDALDatasetUniquePtr written{driver.Create(path(name).c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
    OGRSpatialReference crs;
    if (epsg != 0) crs.importFromEPSG(epsg);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer& layer = *written->CreateLayer("chart", epsg != 0 ? &crs : nullptr, wkbPolygon, nullptr);
    for (const Part& part : parts)
      for (const auto& [field, text] : part.texts)
        if (layer.GetLayerDefn()->GetFieldIndex(field.c_str()) < 0) {
          OGRFieldDefn defined{field.c_str(), OFTString};
          layer.CreateField(&defined);
        }
    for (const Part& part : parts) {
      OGRFeature row{layer.GetLayerDefn()};
      OGRGeometry* geometry = nullptr;
      OGRGeometryFactory::createFromWkt(part.wkt.c_str(), nullptr, &geometry);
      row.SetGeometryDirectly(geometry);
      for (const auto& [field, text] : part.texts) row.SetField(field.c_str(), text.c_str());
      EXPECT_EQ(layer.CreateFeature(&row), OGRERR_NONE);
    }
    return path(name);
  }

  std::optional<ocean::IceState> ice_at(const IngestReport& report, geo::LonLat place) {
    const auto ice = repository::FieldRepository{db_}.load_ice(report.dataset->id, around, std::nullopt);
    return ice ? ice->at(place, report.dataset->time_start.value()) : std::nullopt;
  }
};

std::string square(double west, double south, double east, double north) {
  const auto corner = [](double x, double y) { return std::to_string(x) + " " + std::to_string(y); };
  return "POLYGON ((" + corner(west, south) + "," + corner(east, south) + "," + corner(east, north) + "," +
         corner(west, north) + "," + corner(west, south) + "))";
}

const Part close_pack{square(-60, 65, -58, 66),
                      {{"POLY_TYPE", "I"}, {"CT", "91"}, {"SA", "87"}, {"SB", "84"}}};
const Part young{square(-58, 65, -56, 66), {{"POLY_TYPE", "I"}, {"CT", "46"}, {"SA", "83"}}};
const Part old_ice{square(-56, 65, -54, 66), {{"POLY_TYPE", "I"}, {"CT", "80"}, {"SA", "95"}, {"SB", "91"}}};
const Part water{square(-60, 64, -54, 65), {{"POLY_TYPE", "W"}, {"CT", "55"}}};
const Part land{square(-54, 64, -52, 66), {{"POLY_TYPE", "L"}}};
const Part shelf{square(-60, 66, -58, 67), {{"POLY_TYPE", "S"}, {"CT", "-9"}}};
const Part unseen{square(-58, 66, -56, 67), {{"POLY_TYPE", "N"}}};

TEST_F(IceCharts, KeepTheUpperEndOfEachRangeOfTheirCodes) {
  const auto report = ingest(
      write("cis_SGRDADA_20261120T1800Z_pl_a.shp", {close_pack, young, old_ice, water, land, shelf, unseen}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::ice);
  EXPECT_EQ(core::iso8601(report.dataset->time_start.value()), "2026-11-20T18:00:00Z");
  EXPECT_THAT(messages::sentences(report.warnings), Contains(HasSubstr("was read from its file's name")));
  const auto near = [&](double lon, double lat) { return ice_at(report, {lon, lat}); };
  EXPECT_FLOAT_EQ(static_cast<float>(near(-59.0, 65.5)->concentration), 1.0F);
  EXPECT_NEAR(near(-59.0, 65.5)->thickness->value, 0.7, 1e-6);
  EXPECT_NEAR(near(-57.0, 65.5)->concentration, 0.6, 1e-6);
  EXPECT_NEAR(near(-57.0, 65.5)->thickness->value, 0.3, 1e-6);
  EXPECT_NEAR(near(-55.0, 65.5)->concentration, 0.85, 1e-6);
  EXPECT_FALSE(near(-55.0, 65.5)->thickness) << "old ice has no upper bound";
  EXPECT_EQ(near(-57.0, 64.5)->concentration, 0.0);
  EXPECT_FALSE(near(-53.0, 65.0)) << "land";
  EXPECT_FALSE(near(-57.0, 66.5)) << "not looked at";
  EXPECT_NEAR(near(-59.0, 66.5)->concentration, 1.0, 1e-6);
  EXPECT_GE(near(-59.0, 66.5)->thickness->value, 1000.0) << "closed to every glider";
}

TEST_F(IceCharts, KeepTheirPolygonsWithTheirEggCodes) {
  const Part part{square(-60, 65, -58, 66),
                  {{"POLY_TYPE", "I"},
                   {"CT", "91"},
                   {"CA", "60"},
                   {"SA", "87"},
                   {"FA", "4"},
                   {"CB", "-9"},
                   {"CF", "0403"}}};
  const auto report = ingest(write("cis_SGRDADA_20261120T1800Z_pl_a.shp", {part, water, land}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto polygons = repository::IceChartRepository{db_}.load(report.dataset->id, around);
  ASSERT_THAT(polygons, SizeIs(2)) << "land has no egg";
  using repository::IceCode;
  EXPECT_THAT(polygons[0].codes, ElementsAre(IceCode{"CT", "91"}, IceCode{"CA", "60"}, IceCode{"SA", "87"},
                                             IceCode{"FA", "04"}, IceCode{"CF", "0403"}));
  EXPECT_TRUE(geo::contains(polygons[0].area, {-59.0, 65.5}));
  EXPECT_FALSE(geo::contains(polygons[0].area, {-57.0, 65.5}));
  EXPECT_THAT(polygons[1].codes, ElementsAre(IceCode{"CT", "55"}));
}

TEST_F(IceCharts, OfAreasWithoutCodesHaveNoPolygonsToDraw) {
  const auto report = ingest(
      write("fast_ice_20261120.gpkg", {{square(-60, 65, -58, 66), {{"name", "fast ice"}}}}, 4326, "GPKG"),
      {.kind = repository::DatasetKind::ice});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(repository::IceChartRepository{db_}.load(report.dataset->id, around), SizeIs(0));
}

TEST_F(IceCharts, NeverTellLessIceThanThePolygonsRoundAPlaceHold) {
  const auto report = ingest(write("chart_20261120.gpkg", {close_pack, young, water}, 4326, "GPKG"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto ice = repository::FieldRepository{db_}.load_ice(report.dataset->id, around, std::nullopt);
  ASSERT_TRUE(ice);

  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    const geo::LonLat place{support::uniform(rng, -59.99, -56.0), support::uniform(rng, 64.02, 66.0)};
    const double drawn = place.lat_deg < 65.0 ? 0.0 : place.lon_deg < -58.0 ? 1.0 : 0.6;
    const auto state = ice->at(place, report.dataset->time_start.value());
    ASSERT_TRUE(state) << place.lon_deg << " " << place.lat_deg;
    ASSERT_GE(state->concentration, drawn - 1e-6) << place.lon_deg << " " << place.lat_deg;
  });
}

/// Longitudes that jump from 180 to -180 lead across the antimeridian, not round the Earth.
TEST_F(IceCharts, MayLieAcrossTheAntimeridian) {
  const std::vector<std::pair<std::string, std::string>> closed{
      {"POLY_TYPE", "I"}, {"CT", "92"}, {"SA", "93"}};
  for (const char* const wkt :
       {"POLYGON ((178 70,-178 70,-178 71,178 71,178 70))", "POLYGON ((178 70,182 70,182 71,178 71,178 70))",
        "MULTIPOLYGON (((178 70,180 70,180 71,178 71,178 70)),"
        "((-180 70,-178 70,-178 71,-180 71,-180 70)))"}) {
    SCOPED_TRACE(wkt);
    const auto report = ingest(write("chart_20261120.gpkg", {{wkt, closed}}, 4326, "GPKG"));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto ice = repository::FieldRepository{db_}
                         .load_ice(report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt)
                         .value();
    const core::UtcTime time = report.dataset->time_start.value();
    EXPECT_EQ(ice.at({179.0, 70.5}, time)->concentration, 1.0);
    EXPECT_EQ(ice.at({-179.0, 70.5}, time)->concentration, 1.0);
    for (const double lon : {-170.0, -90.0, 0.0, 90.0, 170.0}) EXPECT_FALSE(ice.at({lon, 70.5}, time)) << lon;
    std::filesystem::remove(path("chart_20261120.gpkg"));
  }
}

TEST_F(IceCharts, MayLieRoundAPole) {
  std::string round;
  for (int lon = -180; lon < 180; lon += 10) round += std::to_string(lon) + " 85,";
  const Part cap{"POLYGON ((" + round + "-180 85))", {{"POLY_TYPE", "I"}, {"CT", "92"}, {"SA", "93"}}};
  const auto report = ingest(write("chart_20261120.shp", {cap}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto ice = repository::FieldRepository{db_}
                       .load_ice(report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt)
                       .value();
  for (double lon = -179.9; lon < 180.0; lon += 11.0) {
    for (const double lat : {86.0, 89.9}) {
      const auto seen = ice.at({lon, lat}, report.dataset->time_start.value());
      ASSERT_TRUE(seen) << lon;
      EXPECT_EQ(seen->concentration, 1.0) << lon;
    }
    EXPECT_FALSE(ice.at({lon, 84.5}, report.dataset->time_start.value())) << lon;
  }
}

TEST_F(IceCharts, InAProjectionLieWhereTheirProjectionSays) {
  // 200 km a side about 62 W, 77.5 N in the projection of the NSIDC.
  const Part projected{
      "POLYGON ((-500000 -1300000,-300000 -1300000,-300000 -1100000,-500000 -1100000,"
      "-500000 -1300000))",
      {{"POLY_TYPE", "I"}, {"CT", "92"}, {"SA", "93"}}};
  const auto report = ingest(write("chart.shp", {projected}, 3413), {.time = core::from_unix_seconds(1.8e9)});
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->time_start, core::from_unix_seconds(1.8e9));
  OGRSpatialReference polar;
  polar.importFromEPSG(3413);
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_wgs84{
      OGRCreateCoordinateTransformation(&polar, &wgs84)};
  const auto ice =
      repository::FieldRepository{db_}.load_ice(report.dataset->id, report.dataset->bounds, std::nullopt);
  ASSERT_TRUE(ice);
  for (const auto& [x, y, inside] : {std::tuple{-400000.0, -1200000.0, true},
                                     {-499000.0, -1299000.0, true},
                                     {-510000.0, -1200000.0, false}}) {
    double lon = x;
    double lat = y;
    ASSERT_EQ(to_wgs84->Transform(1, &lon, &lat), 1);
    EXPECT_EQ(ice->at({lon, lat}, core::from_unix_seconds(1.8e9)).has_value(), inside) << x;
  }
}

TEST_F(IceCharts, WithoutATimeAreAskedForIt) {
  const auto file = write("chart.shp", {close_pack});
  expect_refused(file, "--time");
  EXPECT_EQ(ingest(file, {.time = core::from_unix_seconds(1.8e9)}).status, IngestStatus::stored);
}

TEST_F(IceCharts, WithCodesThatAreNoneAreRefusedPolygonByPolygon) {
  Part tenths = close_pack;
  tenths.texts[1].second = "9+";
  Part stage = young;
  stage.texts[2].second = "42";
  Part type = water;
  type.texts[0].second = "X";
  const auto report = ingest(write("chart_20261120.shp", {tenths, stage, type}));

  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_THAT(report.errors, SizeIs(3)) << words(report);
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("polygon 1: its total concentration CT is \"9+\"")));
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("polygon 2: its stage of development sa is \"42\"")));
  EXPECT_EQ(stored_datasets(), 0U);
}

TEST_F(IceCharts, OfFastIceAreIceAllOver) {
  const Part fast{square(-60, 65, -58, 66), {{"type", "Fast Ice"}, {"thickness", "1.4"}}};
  const auto report = ingest(write("fast_20261120.shp", {fast}));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_NEAR(ice_at(report, {-59.0, 65.5})->concentration, 1.0, 1e-6);
  EXPECT_NEAR(ice_at(report, {-59.0, 65.5})->thickness->value, 1.4, 1e-6);
  EXPECT_FALSE(ice_at(report, {-56.0, 65.5}));
}

TEST_F(IceCharts, OfIceShelvesAloneAreLandBesideTheCoastline) {
  const Part antarctic{square(-60, -75, -58, -74), {{"featurecla", "Antarctic Ice Shelf"}}};
  const auto report = ingest(write("shelves.shp", {antarctic}));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::coastline);
  EXPECT_THAT(report.dataset->variables, ElementsAre(repository::ice_shelves_alone));
}

TEST_F(IceCharts, AndPolygonsThatSayNothingAreAskedWhatTheyAre) {
  const Part silent{square(-60, 65, -58, 66), {{"name", "A"}}};
  for (const char* driver : {"ESRI Shapefile", "GPKG", "GeoJSON", "LIBKML"}) {
    const std::string name = std::string{"a"} + (driver[0] == 'E'   ? ".shp"
                                                 : driver[2] == 'K' ? ".gpkg"
                                                                    : ".x");
    const auto file = write(driver[0] == 'L'   ? "a.kml"
                            : driver[1] == 'e' ? "a.json"
                                               : name,
                            {silent}, 4326, driver);
    expect_refused(file, "--kind zones");
    EXPECT_EQ(ingest(file, {.kind = repository::DatasetKind::coastline}).status, IngestStatus::stored)
        << driver;
    EXPECT_EQ(ingest(file, {.zone_kind = "no_go"}).dataset->kind, repository::DatasetKind::zones) << driver;
    EXPECT_EQ(
        ingest(file, {.kind = repository::DatasetKind::ice, .time = core::from_unix_seconds(1.8e9)}).status,
        IngestStatus::stored)
        << driver;
  }
}

TEST(TimeInName, IsTheMomentThatIceServicesWriteInIt) {
  const auto text = [](const char* name) {
    const auto time = time_in_name(name);
    return time ? core::iso8601(*time) : "";
  };
  EXPECT_EQ(text("cis_SGRDREA_20261116T1800Z_pl_a"), "2026-11-16T18:00:00Z");
  EXPECT_EQ(text("202611151230_Greenland_RIC"), "2026-11-15T12:30:00Z");
  EXPECT_EQ(text("aari_arc_20261117_pl_a"), "2026-11-17T12:00:00Z");
  EXPECT_EQ(text("ARCTIC261119"), "");
  EXPECT_EQ(text("20261301_chart"), "");
  EXPECT_EQ(text("20261117_20261118"), "") << "a period";
  EXPECT_EQ(text("chart"), "");
}

}  // namespace
}  // namespace floeplan::ingest::ice_chart_test
