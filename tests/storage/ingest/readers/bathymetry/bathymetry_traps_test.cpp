#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/grid_frame.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/readers/bathymetry/vertical_sense.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::bathymetry_traps_test {
namespace {

using testing::HasSubstr;

const IngestOptions positive_up{.name = {}, .kind = {}, .crs = {}, .positive = "up"};

float least_of(const std::vector<float>& depths_m) {
  float least = std::numeric_limits<float>::infinity();
  for (const float depth_m : depths_m)
    if (depth_m < least) least = depth_m;  // a missing one compares as false
  return least;
}

class BathymetryTraps : public StoreFixture {
 protected:
  std::unique_ptr<GDALDataset> made_tiff(const std::string& crs, std::array<double, 6> transform,
                                         int bands) const {
    register_drivers();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    std::unique_ptr<GDALDataset> dataset{
        driver->Create(path("sea.tif").c_str(), 4, 3, bands, GDT_Float32, nullptr)};
    if (!crs.empty()) {
      OGRSpatialReference reference;
      reference.SetFromUserInput(crs.c_str());
      dataset->SetSpatialRef(&reference);
    }
    dataset->SetGeoTransform(transform.data());
    return dataset;
  }

  static void fill(GDALRasterBand& band, std::vector<double> values, const std::string& description) {
    band.SetDescription(description.c_str());
    EXPECT_EQ(band.RasterIO(GF_Write, 0, 0, 4, 3, values.data(), 4, 3, GDT_Float64, 0, 0, nullptr), CE_None);
  }

  /// A GeoTIFF of 4 x 3 pixels: elevations -10, -20, ... by rows from the north.
  std::filesystem::path write_tiff(const std::string& crs, std::array<double, 6> transform,
                                   double factor = -10.0,
                                   const std::string& description = "elevation") const {
    const std::unique_ptr<GDALDataset> dataset = made_tiff(crs, transform, 1);
    std::vector<double> values;
    for (int i = 1; i <= 12; ++i) values.push_back(factor * i);
    fill(*dataset->GetRasterBand(1), std::move(values), description);
    return path("sea.tif");
  }

  /// Where PROJ puts a point of a plane on WGS84.
  static geo::LonLat place_in(const std::string& crs, geo::GridPoint point) {
    OGRSpatialReference from;
    from.SetFromUserInput(crs.c_str());
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference to;
    to.SetWellKnownGeogCS("WGS84");
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> way{OGRCreateCoordinateTransformation(&from, &to)};
    EXPECT_NE(way->Transform(1, &point.x, &point.y), 0);
    return {point.x, point.y};
  }

  ocean::Bathymetry depths_at(geo::LonLat place) {
    return repository::FieldRepository{db_}
        .load_bathymetry(report_.dataset->id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg})
        .value();
  }

  /// That the file of `write_tiff` has its own depths at the centres of its pixels.
  void expect_own_depths(const std::string& crs, const std::array<double, 6>& t) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) {
        const double across = column + 0.5;
        const double down = row + 0.5;
        const geo::LonLat place =
            place_in(crs, {t[0] + t[1] * across + t[2] * down, t[3] + t[4] * across + t[5] * down});
        const auto here = depths_at(place);
        EXPECT_EQ(here.depth(place).value().value, 10.0 * (row * 4 + column + 1)) << crs;
        EXPECT_EQ(here.shoalest(place).value().value, here.depth(place).value().value);
      }
  }

  ocean::Bathymetry stored(const std::filesystem::path& file, const IngestOptions& options = {}) {
    report_ = ingest(file, options);
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    if (!report_.dataset) throw std::runtime_error{"nothing was stored"};
    return repository::FieldRepository{db_}
        .load_bathymetry(report_.dataset->id, {-180.0, -90.0, 180.0, 90.0})
        .value();
  }

  /// Depths over 3 x 2 nodes.
  void write_netcdf(const std::string& name, std::map<std::string, std::string> texts,
                    std::vector<double> values) const {
    NetcdfWriter writer{path("sea.nc")};
    writer.axis("lat", {50.0, 51.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {0.0, 1.0, 2.0}, {{"units", "degrees_east"}});
    writer.variable({.name = name,
                     .dimensions = {"lat", "lon"},
                     .values = std::move(values),
                     .texts = std::move(texts),
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float32});
  }

  IngestReport report_;
};

TEST_F(BathymetryTraps, PixelsStandForTheirCentresAndRowsAreTurned) {
  const auto sea = stored(write_tiff("EPSG:4326", {10.0, 1.0, 0.0, 60.0, 0.0, -1.0}));

  EXPECT_EQ(sea.grid().x().front(), 10.5);
  EXPECT_EQ(sea.grid().y().front(), 57.5);
  EXPECT_FLOAT_EQ(sea.depth_m()[0], 90.0F);  // first pixel of the southernmost row
  EXPECT_DOUBLE_EQ(sea.depth({13.5, 59.5})->value, 40.0);
}

TEST_F(BathymetryTraps, AUtmGridKeepsItsNodes) {
  const auto sea = stored(write_tiff("EPSG:32621", {500000.0, 100.0, 0.0, 7600000.0, 0.0, -100.0}));

  ASSERT_TRUE(std::holds_alternative<geo::TransverseMercatorFrame>(sea.grid().frame()));
  EXPECT_EQ(sea.grid().x().front(), 500050.0);
  EXPECT_DOUBLE_EQ(sea.depth(sea.grid().place(0, 0))->value, 90.0);
}

/// At the centre of every pixel its own depth, wherever PROJ puts it.
TEST_F(BathymetryTraps, AGridInAnyOfTheUsualProjectionsKeepsItsNodes) {
  struct Sea {
    const char* crs;
    double west;
    double north;
  };
  for (const Sea& sea :
       {Sea{"EPSG:32661", 1.4e6, 1.5e6}, Sea{"EPSG:3034", 3.7e6, 3.8e6},
        Sea{"EPSG:3035", 4321000.0, 3230000.0}, Sea{"EPSG:3338", -4.4e5, 2.4e6},
        Sea{"EPSG:6931", -1.7e6, -1.4e6}, Sea{"EPSG:6932", 2.2e5, -1.3e6}, Sea{"EPSG:6933", -4.8e6, 6.8e6},
        Sea{"EPSG:3395", -5.5e6, 1.0e7}, Sea{"EPSG:3857", -5.5e6, 1.0e7}, Sea{"EPSG:3832", 4.4e6, 7.1e6},
        Sea{"EPSG:2154", 1.0e5, 6.9e6}, Sea{"EPSG:2225", 5.9e6, 2.2e6}}) {
    SCOPED_TRACE(sea.crs);
    const std::array<double, 6> transform{sea.west, 1000.0, 0.0, sea.north, 0.0, -1000.0};
    const auto depths = stored(write_tiff(sea.crs, transform));

    EXPECT_FALSE(std::holds_alternative<geo::GeographicFrame>(depths.grid().frame())) << sea.crs;
    EXPECT_EQ(depths.grid().size(), 12U) << sea.crs;
    expect_own_depths(sea.crs, transform);
  }
}

/// UTM on GRS 1980 (ETRS89, NAD83) lies up to 0.1 mm beside UTM on WGS84, 50 millionths of a pixel here. At the edge of a
/// survey, a place beside the last node has no depth.
TEST_F(BathymetryTraps, ASurveyOnGrs1980HasItsNodesWhereItSays) {
  const std::array<double, 6> transform{650000.0, 2.0, 0.0, 7600000.0, 0.0, -2.0};
  const auto sea = stored(write_tiff("EPSG:25832", transform));

  EXPECT_EQ(std::get<geo::TransverseMercatorFrame>(sea.grid().frame()).ellipsoid, geo::grs_1980);
  expect_own_depths("EPSG:25832", transform);
}

/// EPSG gave up EASE-Grid 1, which lies on a sphere, for EASE-Grid 2 on WGS84.
TEST_F(BathymetryTraps, AGivenUpReferenceSystemIsNotTakenForItsSuccessor) {
  const auto sea = stored(write_tiff("EPSG:3409", {2.2e5, 1000.0, 0.0, -1.3e6, 0.0, -1000.0}));

  const auto frame = std::get<geo::AlbersFrame>(sea.grid().frame());
  EXPECT_EQ(frame.ellipsoid, (geo::Ellipsoid{6'371'228.0, 0.0}));
}

/// Half-way between four pixels of the plane, not of their longitudes and latitudes.
TEST_F(BathymetryTraps, BetweenPixelsOfAProjectionDepthsAreBilinearInItsPlane) {
  stored(write_tiff("EPSG:3035", {4321000.0, 10000.0, 0.0, 3230000.0, 0.0, -10000.0}));

  const geo::LonLat place = place_in("EPSG:3035", {4333500.0, 3217500.0});
  EXPECT_NEAR(depths_at(place).depth(place).value().value, 0.25 * 17.5 + 0.75 * 57.5, 1e-5);
}

TEST_F(BathymetryTraps, AGridThatItsProjectionCutsOpenIsKeptAtItsOwnPlaces) {
  const std::array<double, 6> transform{2.0e7, 20000.0, 0.0, 7.0e6, 0.0, -20000.0};
  stored(write_tiff("EPSG:3395", transform));

  EXPECT_THAT(words(report_), HasSubstr("kept at its own place (12 points"));
  expect_own_depths("EPSG:3395", transform);
}

TEST_F(BathymetryTraps, PixelsOfAnotherProjectionAreKeptAtTheirOwnPlaces) {
  const std::array<double, 6> transform{780000.0, 10000.0, 0.0, 720000.0, 0.0, -10000.0};
  stored(write_tiff("EPSG:26931", transform));

  EXPECT_THAT(words(report_), HasSubstr("kept at its own place (12 points, a grid in \"NAD83 / Alaska"));
  expect_own_depths("EPSG:26931", transform);
}

TEST_F(BathymetryTraps, PixelsOfARotatedGridAreKeptAtTheirOwnPlaces) {
  const std::array<double, 6> transform{500000.0, 900.0, 300.0, 7600000.0, 300.0, -900.0};
  stored(write_tiff("EPSG:32621", transform));

  expect_own_depths("EPSG:32621", transform);
}

/// The datum of North America of 1927 lies about 80 m beside WGS84 here; PROJ knows how far.
TEST_F(BathymetryTraps, AGridOnAnOldDatumIsMovedToWgs84) {
  const std::array<double, 6> transform{-70.0, 0.01, 0.0, 44.0, 0.0, -0.01};
  stored(write_tiff("EPSG:4267", transform));

  expect_own_depths("EPSG:4267", transform);
  const geo::LonLat moved = place_in("EPSG:4267", {-69.995, 43.995});
  EXPECT_GT(geo::geodesic_between(moved, {-69.995, 43.995}).length.value, 20.0);
}

/// Alaska's Albers plane: the middle of this grid is 180 E, 54 N, by gdaltransform.
TEST_F(BathymetryTraps, AGridAcrossTheAntimeridianIsNotTakenRoundTheEarth) {
  const std::array<double, 6> transform{-1704000.0, 20000.0, 0.0, 803000.0, 0.0, -20000.0};
  const auto sea = stored(write_tiff("EPSG:3338", transform));

  EXPECT_LT(geo::width_deg(sea.grid().bounds()), 5.0);
  EXPECT_TRUE(sea.depth({179.9, 54.0}).has_value());
  EXPECT_TRUE(sea.depth({-179.9, 54.0}).has_value());
  expect_own_depths("EPSG:3338", transform);
}

/// The pole is one corner of this plane of the Arctic.
TEST_F(BathymetryTraps, AGridAtThePoleIsReadUpToIt) {
  const std::array<double, 6> transform{-20000.0, 10000.0, 0.0, 20000.0, 0.0, -10000.0};
  const auto sea = stored(write_tiff("EPSG:3571", transform));

  EXPECT_TRUE(sea.depth({77.0, 89.999}).has_value());
  expect_own_depths("EPSG:3571", transform);
}

TEST_F(BathymetryTraps, BetweenPixelsOfAnotherProjectionTheShoalestCounts) {
  const auto sea = stored(write_tiff("EPSG:26931", {780000.0, 10000.0, 0.0, 720000.0, 0.0, -10000.0}));

  const geo::LonLat beside_the_rock = place_in("EPSG:26931", {793000.0, 707000.0});
  EXPECT_LE(sea.shoalest(beside_the_rock).value().value, 10.0) << "the rock of the first pixel";
  for (std::size_t i = 0; i < sea.depth_m().size(); ++i)
    EXPECT_TRUE(std::isnan(sea.depth_m()[i]) || sea.shoalest_m()[i] <= sea.depth_m()[i]);
}

TEST_F(BathymetryTraps, TheUncertaintyOfADepthIsKeptAtItsOwnPlace) {
  const std::array<double, 6> transform{780000.0, 10000.0, 0.0, 720000.0, 0.0, -10000.0};
  {
    const std::unique_ptr<GDALDataset> dataset = made_tiff("EPSG:26931", transform, 2);
    std::vector<double> values;
    for (int i = 1; i <= 12; ++i) values.push_back(-10.0 * i);
    fill(*dataset->GetRasterBand(1), values, "elevation");
    fill(*dataset->GetRasterBand(2), std::vector<double>(12, 1.5), "uncertainty");
  }
  stored(path("sea.tif"));

  const auto last = depths_at(place_in("EPSG:26931", {815000.0, 695000.0}));
  EXPECT_FLOAT_EQ(last.depth_m().front(), 120.0F);
  EXPECT_FLOAT_EQ(last.shoalest_m().front(), 118.5F);
}

/// A mesh of more points does not fit into the memory of the reading process.
TEST_F(BathymetryTraps, ALargerGridOfAnotherProjectionIsRefusedWithTheWayOut) {
  register_drivers();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const char* const options[] = {"SPARSE_OK=TRUE", nullptr};
  {
    const std::unique_ptr<GDALDataset> dataset{
        driver->Create(path("sea.tif").c_str(), 2000, 1001, 1, GDT_Float32, const_cast<char**>(options))};
    OGRSpatialReference reference;
    reference.SetFromUserInput("EPSG:26931");
    dataset->SetSpatialRef(&reference);
    std::array<double, 6> transform{780000.0, 100.0, 0.0, 720000.0, 0.0, -100.0};
    dataset->SetGeoTransform(transform.data());
  }

  expect_refused(path("sea.tif"), "Cut out your area first, for example with gdal_translate -projwin",
                 positive_up);
}

/// Band values at pixel (22, 107), counted from the north-west, as gdallocationinfo prints them.
TEST_F(BathymetryTraps, ASurveyMayBeAsShoalAsItsUncertaintyAllows) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto sea = stored(sample_folder() / "bathymetry/F00788_SR_8m.tif");

  const std::size_t node = (179 - 1 - 107) * 179 + 22;
  EXPECT_NEAR(sea.depth_m()[node], 59.3783569F, 1e-4F);
  EXPECT_NEAR(sea.shoalest_m()[node], 59.3783569F - 0.4645371F, 1e-4F);
}

/// Its description says EPSG 6339, UTM of zone 10 north; the south-west corner was brought to degrees with
/// gdaltransform.
TEST_F(BathymetryTraps, ABagThatNamesItsReferenceSystemByItsCodeIsPlacedByIt) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto sea = stored(sample_folder() / "bathymetry/Sample_VR_BAG-gzip.bag");

  const geo::LonLat corner = sea.grid().place(0, 0);
  EXPECT_NEAR(corner.lon_deg, -122.4261764, 1e-7);
  EXPECT_NEAR(corner.lat_deg, 47.6715405, 1e-7);
}

/// gdalinfo -stats: on the finest grid the elevations of the highest measurements reach up to -20.0436 m, in the plain
/// view, whose cells are 50 m wide, up to -20.3850 m only.
TEST_F(BathymetryTraps, ABagOfVariableResolutionIsReadAtItsFinest) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto sea = stored(sample_folder() / "bathymetry/Sample_VR_BAG-gzip.bag",
                          {.name = {}, .kind = {}, .crs = "EPSG:32610", .positive = "up"});

  EXPECT_EQ(sea.grid().size(), 100U * 100U);
  const float least = least_of(sea.shoalest_m());
  EXPECT_LT(least, 20.0436F);
  EXPECT_GT(least, 20.0436F - 0.517F) << "the largest uncertainty";
}

TEST_F(BathymetryTraps, AGridWithoutACrsIsRefusedUnlessTheUserStatesOne) {
  const auto file = write_tiff("", {10.0, 1.0, 0.0, 60.0, 0.0, -1.0});

  expect_refused(file, "--crs");
  EXPECT_EQ(ingest(file, {.name = {}, .kind = {}, .crs = "EPSG:4326", .positive = {}}).status,
            IngestStatus::stored);
}

TEST_F(BathymetryTraps, ALatitudeOf95IsRefused) {
  expect_refused(write_tiff("EPSG:4326", {10.0, 1.0, 0.0, 96.0, 0.0, -1.0}), "beyond the poles");
}

TEST_F(BathymetryTraps, DepthsThatNoOceanHasAreRefused) {
  expect_refused(write_tiff("EPSG:4326", {10.0, 1.0, 0.0, 60.0, 0.0, -1.0}, -1001.0),
                 "exists nowhere on Earth");
}

TEST_F(BathymetryTraps, AGridThatDoesNotSayItsSenseIsRefusedUntilTheUserDoes) {
  const auto file = write_tiff("EPSG:4326", {10.0, 1.0, 0.0, 60.0, 0.0, -1.0}, -10.0, "");

  expect_refused(file, "--positive");
  EXPECT_FLOAT_EQ(stored(file, positive_up).depth_m()[0], 90.0F);
}

TEST_F(BathymetryTraps, ATruncatedGeotiffIsRefused) {
  const auto file = write_tiff("EPSG:4326", {10.0, 1.0, 0.0, 60.0, 0.0, -1.0});
  std::filesystem::resize_file(file, 20);
  expect_refused(file, "cut short");
}

TEST_F(BathymetryTraps, APictureIsRefused) {
  register_drivers();
  {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    const std::unique_ptr<GDALDataset> dataset{
        driver->Create(path("chart.tif").c_str(), 4, 3, 1, GDT_Byte, nullptr)};
    GDALColorTable colours;
    const GDALColorEntry blue{0, 0, 255, 255};
    colours.SetColorEntry(0, &blue);
    dataset->GetRasterBand(1)->SetColorTable(&colours);
  }
  expect_refused(path("chart.tif"), "picture");
}

TEST_F(BathymetryTraps, AttributesDecideTheSense) {
  write_netcdf("deptho", {{"units", "m"}, {"standard_name", "sea_floor_depth_below_geoid"}},
               {1, 2, 3, 4, 5, 6});
  EXPECT_FLOAT_EQ(stored(path("sea.nc")).depth_m()[0], 1.0F);

  write_netcdf("z", {{"units", "km"}, {"positive", "up"}}, {-1, -2, -3, -4, -5, -6});
  EXPECT_FLOAT_EQ(stored(path("sea.nc")).depth_m()[5], 6000.0F);
}

TEST_F(BathymetryTraps, ADepthThatLooksLikeElevationIsRefused) {
  write_netcdf("depth", {{"units", "m"}}, {-1, -2, -3, -4, -5, -6});
  expect_refused(path("sea.nc"), "as elevations do");
}

TEST_F(BathymetryTraps, DepthsInAnyUnitOfLengthBecomeMetres) {
  struct Unit {
    const char* name;
    double metres;
  };
  support::for_each_seed(24, [&](std::mt19937_64& rng) {
    constexpr std::array units{Unit{"m", 1.0},          Unit{"ft", 0.3048}, Unit{"feet", 0.3048},
                               Unit{"fathoms", 1.8288}, Unit{"cm", 0.01},   Unit{"km", 1000.0}};
    const Unit unit = units.at(static_cast<std::size_t>(support::uniform_int(rng, 0, 5)));
    const double depth_m = support::uniform(rng, 20.0, 4000.0);
    const bool described = support::uniform_int(rng, 0, 1) == 0;
    std::filesystem::remove(path("depth.nc"));
    {
      NetcdfWriter writer{path("depth.nc")};
      writer.axis("lat", {50.0, 51.0, 52.0}, {{"units", "degrees_north"}});
      writer.axis("lon", {1.0, 2.0, 3.0}, {{"units", "degrees_east"}});
      writer.variable({.name = "depth",
                       .dimensions = {"lat", "lon"},
                       .values = std::vector<double>(9, depth_m / unit.metres),
                       .texts = {{"units", unit.name},
                                 {described ? "standard_name" : "long_name",
                                  described ? "sea_floor_depth_below_sea_surface"
                                            : "depth of the bed below the sea surface"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    }
    const auto depths = stored(path("depth.nc"));
    const auto least = least_of(depths.depth_m());
    EXPECT_NEAR(least, depth_m, 1e-3 * depth_m) << unit.name;
  });
}

/// Files as in a public report on other programs.
TEST_F(BathymetryTraps, DepthsOfACaseInOtherUnitsAreThoseThatItStates) {
  const auto cases =
      std::filesystem::path{support::source_folder()} / "../shared/data/cases/17-small-refusals";
  if (!std::filesystem::exists(cases)) GTEST_SKIP() << "the sample data are not on this machine";
  for (const char* const name : {"depth_fathoms.nc", "depth_ft.nc", "depth_cm.nc"}) {
    const auto sea = stored(cases / name);
    EXPECT_NEAR(sea.depth({-7.5, 52.0}).value().value, 100.0 + 20.0 * 2.5 + 10.0 * 2.0, 1e-3) << name;
  }
}

TEST_F(BathymetryTraps, DynamicTopographyIsNotTheSeaFloor) {
  write_netcdf("adt", {{"units", "m"}, {"long_name", "Absolute dynamic topography"}}, {1, 2, 3, 4, 5, 6});
  expect_refused(path("sea.nc"), "no currents, depths, sea ice or wind");
}

TEST_F(BathymetryTraps, AnUndeclaredMarkerIsLeftOutWithAWarning) {
  write_netcdf("elevation", {{"units", "m"}}, {-32768, -2, -3, -4, -5, -9999});

  const auto sea = stored(path("sea.nc"));

  EXPECT_TRUE(std::isnan(sea.depth_m()[0]));
  EXPECT_TRUE(std::isnan(sea.depth_m()[5]));
  EXPECT_THAT(words(report_), HasSubstr("2 values were left out, because they stand for a missing depth"));
}

TEST_F(BathymetryTraps, PlainTextInMetresIsNotTakenForDegrees) {
  const auto file =
      write_file("local.asc",
                 "ncols 2\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 1\nNODATA_value -9999\n1 2\n3 4\n");
  expect_refused(file, "--crs", positive_up);
}

TEST_F(BathymetryTraps, AnAsciiGridThatWasCutShortIsRefused) {
  const std::string header =
      "ncols 2\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 0.5\nNODATA_value -9999\n";
  expect_refused(write_file("cut.asc", header + "1 2\n3"), "announces 4 values, but it has only 3",
                 positive_up);
  expect_refused(write_file("cut.asc", "ncols 2\nnro"), "no usable ncols and nrows", positive_up);
}

TEST_F(BathymetryTraps, AnAsciiGridMayWriteItsDecimalsWithAComma) {
  const auto sea = stored(
      write_file("comma.asc",
                 "ncols 2\nnrows 2\nxllcorner 9,75\nyllcorner 19,75\ncellsize 0,5\nNODATA_value -9999\n"
                 "-1,5 -2,5\n-3,5 -9999,0\n"),
      IngestOptions{.name = {}, .kind = {}, .crs = "EPSG:4326", .positive = "up"});

  EXPECT_DOUBLE_EQ(sea.depth({10.0, 20.5})->value, 1.5);
  EXPECT_DOUBLE_EQ(sea.depth({10.5, 20.5})->value, 2.5);
  EXPECT_DOUBLE_EQ(sea.depth({10.0, 20.0})->value, 3.5);
  EXPECT_TRUE(std::isnan(sea.depth_m()[1]));
}

TEST_F(BathymetryTraps, ReasonsDoNotTellWhereTheFileLies) {
  const auto file = write_file("sea.tif", std::string{"II*\0\xff\xff\0\0", 8});
  EXPECT_THAT(words(ingest(file)), testing::Not(HasSubstr(file.parent_path().string())));
}

TEST_F(BathymetryTraps, AnXyzTableWithHolesIsRefused) {
  expect_refused(write_file("survey.xyz", "0.0 50.0 -10\n0.013 50.002 -11\n0.2 50.1 -12\n0.21 50.4 -7\n"),
                 "regular grid", positive_up);
}

TEST_F(BathymetryTraps, ATableWithNamedColumnsIsReadAsItsColumnsSay) {
  const std::vector<std::string> tables{
      "lon,lat,depth\n-52.0,69.0,100\n-51.9,69.0,200\n-52.0,69.1,300\n-51.9,69.1,400\n",
      "\"Latitude\"\t\"Longitude\"\t\"Elevation "
      "(m)\"\n69.1\t-51.9\t-400\n69.0\t-52.0\t-100\n69.0\t-51.9\t-200\n"
      "69.1\t-52.0\t-300\n",
      "station;x;y;depth_m\n1;-52.0;69.0;100\n2;-52.0;69.1;300\n3;-51.9;69.0;200\n4;-51.9;69.1;400\n",
      "# lon lat   depth\n-52.0 69.0 100\n-51.9 69.0   200\n-52.0 69.1 300\n-51.9 69.1 400\n"};
  for (const std::string& table : tables) {
    SCOPED_TRACE(table);
    const ocean::Bathymetry bathymetry = stored(write_file("depths.csv", table));

    EXPECT_NEAR(bathymetry.depth({-51.9, 69.0})->value, 200.0, 1e-3);
    EXPECT_NEAR(bathymetry.depth({-52.0, 69.1})->value, 300.0, 1e-3);
  }
}

TEST_F(BathymetryTraps, ATableOfSingleSoundingsIsRefused) {
  expect_refused(
      write_file("soundings.csv", "lon,lat,depth\n0.0,50.0,10\n0.013,50.002,11\n0.2,50.1,12\n0.21,50.4,7\n"),
      "not a regular grid");
}

TEST_F(BathymetryTraps, ATableWithABadLineOrTwoDepthsAtAPlaceIsRefused) {
  const std::string good = "lon,lat,depth\n0.0,50.0,10\n0.1,50.0,11\n0.0,50.1,12\n0.1,50.1,13\n";
  expect_refused(write_file("bad.csv", good + "0.1,fifty,3\n"), "line 6");
  expect_refused(write_file("short.csv", good + "0.1,50.1\n"), "line 6");
  expect_refused(write_file("twice.csv", good + "0.1,50.1,14\n"), "two depths");
  expect_refused(write_file("none.csv", "lon,lat,depth\n"), "no rows");
  EXPECT_EQ(ingest(write_file("again.csv", good + "0.1,50.1,13\n")).status, IngestStatus::stored);
}

TEST_F(BathymetryTraps, ATableThatEndsWithinALineIsStoredWithAWarning) {
  const std::string rows = "0.0 50.1 -10\n0.1 50.1 -11\n0.0 50.0 -12\n0.1 50.0 -13";

  EXPECT_THAT(words(ingest(write_file("cut.xyz", rows), positive_up)),
              HasSubstr("last line has no line end"));
  EXPECT_THAT(words(ingest(write_file("whole.xyz", rows + "\n"), positive_up)),
              testing::Not(HasSubstr("last line has no line end")));
}

TEST(VerticalSense, OfAWholeGlobeIsUnmistakable) {
  const VerticalDescription silent{.name = "Band1", .standard_name = "", .long_name = "", .positive = ""};
  EXPECT_EQ(vertical_sense_of({}, silent, {-10500.0, 6100.0, true})->sense, VerticalSense::up);
  EXPECT_EQ(vertical_sense_of({}, silent, {-6100.0, 10500.0, true})->sense, VerticalSense::down);
  EXPECT_TRUE(vertical_sense_of({}, silent, {-10500.0, 6100.0, true})->warning.has_value());
  EXPECT_FALSE(vertical_sense_of({}, silent, {-10500.0, 6100.0, false}));
  EXPECT_FALSE(vertical_sense_of({}, silent, {-5000.0, 3000.0, true}));
}

TEST(VerticalSense, IsWhatTheUserSaysAboveAll) {
  const VerticalDescription depth{
      .name = "depth", .standard_name = "depth", .long_name = "", .positive = "down"};
  EXPECT_EQ(vertical_sense_of("up", depth, {-10.0, 0.0, false})->sense, VerticalSense::up);
  EXPECT_FALSE(vertical_sense_of("sideways", depth, {-10.0, 0.0, false}));
}

}  // namespace
}  // namespace floeplan::ingest::bathymetry_traps_test
