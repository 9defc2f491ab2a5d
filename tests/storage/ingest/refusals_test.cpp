#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <fstream>
#include <iterator>

#include "storage/ingest/common/gdal_guard.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::refusals_test {
namespace {

class Refusals : public StoreFixture {
 protected:
  void expect_refused_currents(const CurrentFile& content, const std::string& reason) {
    content.write(path("currents.nc"));
    expect_refused(path("currents.nc"), reason);
  }
  /// The first bytes of a file, up to `share` of its size.
  std::filesystem::path cut_short(const std::filesystem::path& file, double share) const {
    std::ifstream in{file, std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
    return write_file("cut_" + file.filename().string(),
                      bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
  }
};

TEST_F(Refusals, AFileThatIsNotThere) { expect_refused(path("nowhere.nc"), "no such file"); }

TEST_F(Refusals, AnEmptyFile) { expect_refused(write_file("empty.nc", ""), "empty"); }

TEST_F(Refusals, ATextNamedLikeNetcdf) {
  expect_refused(write_file("page.nc", "<html>Sign in to download</html>\n"), "holds text");
}

TEST_F(Refusals, AGlidersMeasurementsOfTheWater) {
  expect_refused(
      write_file("ctd.csv",
                 "time,latitude,longitude,depth,temperature,salinity\n"
                 "2026-11-20T06:00:00Z,69.2,-52.1,12.5,1.3,33.1\n"),
      "measurements of the water (columns time, latitude, longitude, depth, temperature and salinity)");
  expect_refused(write_file("ctd.txt", "timestamp pressure conductivity\n0 12.5 2.9\n"),
                 "measurements of the water");
}

TEST_F(Refusals, AZarrStoreWithNothingInIt) {
  std::filesystem::create_directories(path("store.zarr"));
  write_file("store.zarr/zarr.json", R"({"zarr_format": 3, "node_type": "group"})");
  expect_refused(path("store.zarr"), "no variables");
}

TEST_F(Refusals, ATideModelInTheBinaryFormatOfOtis) {
  const std::string eight_by_six{"\0\0\0\x08\0\0\0\x06", 8};
  const std::string limits(16, '\x42');
  const std::string constituents = std::string{"\0\0\0\x24", 4} + eight_by_six +
                                   std::string{"\0\0\0\x02", 4} + limits + "m2  s2  " +
                                   std::string{"\0\0\0\x24", 4} + std::string(100, '\0');
  expect_refused(write_file("h_arc", constituents), "OTIS");

  const std::string grid = std::string{"\0\0\0\x20", 4} + eight_by_six + limits + std::string(8, '\0') +
                           std::string{"\0\0\0\x20", 4} + std::string(100, '\0');
  expect_refused(write_file("grid_arc", grid), "OTIS");
}

TEST_F(Refusals, AGridOfAnOldGmt) {
  NetcdfWriter file{path("old.grd")};
  file.dimension("side", 2);
  file.dimension("xysize", 6);
  for (const char* name : {"x_range", "y_range", "z_range", "spacing"})
    file.variable(
        {.name = name, .dimensions = {"side"}, .values = {1.0, 2.0}, .texts = {}, .numbers = {}, .fill = {}});
  file.variable({.name = "z",
                 .dimensions = {"xysize"},
                 .values = {1, 2, 3, 4, 5, 6},
                 .texts = {},
                 .numbers = {},
                 .fill = {}});

  expect_refused(path("old.grd"), "gmt grdconvert");
}

TEST_F(Refusals, ARasterInAGeoPackage) {
  register_drivers();
  {
    const GDALDatasetUniquePtr raster{GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
        path("bed.gpkg").c_str(), 4, 3, 1, GDT_Float32, nullptr)};
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    raster->SetSpatialRef(&wgs84);
    std::array transform{10.0, 1.0, 0.0, 60.0, 0.0, -1.0};
    raster->SetGeoTransform(transform.data());
    std::vector<float> values(12, -100.0F);
    EXPECT_EQ(
        raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 3, values.data(), 4, 3, GDT_Float32, 0, 0),
        CE_None);
  }
  expect_refused(path("bed.gpkg"), "gdal_translate");
}

TEST_F(Refusals, SeaIceInARasterThatHoldsNoNames) {
  const auto file =
      write_file("asi.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 80\ncellsize 1\n100 90\n20 120\n");
  expect_refused(file, "gdal_translate -of netCDF", {.kind = repository::DatasetKind::ice});
}

/// The wind of ERA5 where its latest months are in it, and any forecast of many members.
TEST_F(Refusals, SeveralStatesOfTheSameTime) {
  for (const auto& [dimension, reason] :
       {std::pair{"expver", "ERA5T"}, std::pair{"number", "ncks -d number,0"}}) {
    {
      NetcdfWriter writer{path("wind.nc")};
      writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
      writer.axis(dimension, {1.0, 5.0}, {{"long_name", dimension}});
      writer.axis("lat", {60.0, 61.0}, {{"units", "degrees_north"}});
      writer.axis("lon", {5.0, 6.0}, {{"units", "degrees_east"}});
      for (const char* const name : {"u10", "v10"})
        writer.variable({.name = name,
                         .dimensions = {"time", dimension, "lat", "lon"},
                         .values = {1, 2, 3, 4, 5, 6, 7, 8},
                         .texts = {{"units", "m s-1"}},
                         .numbers = {},
                         .fill = {}});
    }
    expect_refused(path("wind.nc"), reason);
    std::filesystem::remove(path("wind.nc"));
  }
}

TEST_F(Refusals, AGribFile) { expect_refused(write_file("gfs.nc", std::string{"GRIB\0\0\0\2", 8}), "GRIB"); }

TEST_F(Refusals, BytesWithoutMeaning) {
  expect_refused(write_file("noise.nc", std::string{"\x01\x02\x03\x00\x04", 5}), "is not recognised");
}

TEST_F(Refusals, ANetworkAddress) { expect_refused("/vsicurl/http://127.0.0.1:9/a.nc", "no such file"); }

TEST_F(Refusals, AVirtualFormat) {
  expect_refused(write_file("sea.vrt", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"/>\n"),
                 "not recognised");
}

TEST_F(Refusals, ANetcdf4FileThatWasCutShort) {
  CurrentFile{}.write(path("currents.nc"));
  expect_refused(cut_short(path("currents.nc"), 0.6), "cut short");
}

TEST_F(Refusals, AClassicNetcdfFileThatWasCutShort) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto whole = sample_folder() / "currents/gnome_gridded_current.nc";
  expect_refused(cut_short(whole, 0.9), "cut short");
  expect_refused(cut_short(whole, 0.001), "cut short");
}

TEST_F(Refusals, TimesWithoutUnits) {
  CurrentFile file;
  file.time_texts = {{"standard_name", "time"}};
  expect_refused_currents(file, "no units");
}

TEST_F(Refusals, TimesThatCannotBeDecoded) {
  CurrentFile file;
  file.time_texts = {{"units", "hours since the flood"}};
  expect_refused_currents(file, "hours since the flood");
}

TEST_F(Refusals, TwoStepsOfTheSameTime) {
  CurrentFile file;
  file.times = {6.0, 6.0};
  expect_refused_currents(file, "same time");
}

TEST_F(Refusals, DatesThatOnlyAModelHas) {
  CurrentFile file;
  file.times = {58.0, 59.0};
  file.time_texts = {{"units", "days since 2001-01-01"}, {"calendar", "360_day"}};
  expect_refused_currents(file, "only the model's calendar has");
}

TEST_F(Refusals, NothingButMissingValues) {
  CurrentFile file;
  file.fill = -9.0;
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t) { return -9.0; };
  expect_refused_currents(file, "is missing");
}

TEST_F(Refusals, NothingButZeros) {
  CurrentFile file;
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t) { return 0.0; };
  expect_refused_currents(file, "exactly zero");
}

TEST_F(Refusals, ACurrentThatNoOceanHas) {
  CurrentFile file;
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t x) { return x == 2 ? 12.0 : 0.1; };
  expect_refused_currents(file, "faster than any ocean current");
}

TEST_F(Refusals, ADecodedFillOfHycom) {
  CurrentFile file;
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t x) {
    return x == 2 ? -30.0 : 0.1;
  };
  expect_refused_currents(file, "faster than any ocean current");
}

TEST_F(Refusals, LargeNumbersWithoutAUnit) {
  CurrentFile file;
  file.u_texts.erase("units");
  file.v_texts.erase("units");
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t) { return 35.0; };
  expect_refused_currents(file, "cm/s");
}

TEST_F(Refusals, AUnitThatIsNoSpeed) {
  CurrentFile file;
  file.u_texts["units"] = "furlongs per fortnight";
  expect_refused_currents(file, "furlongs per fortnight");
}

TEST_F(Refusals, ALatitudeBeyondThePole) {
  CurrentFile file;
  file.lats = {93.0, 94.0, 95.0};
  expect_refused_currents(file, "beyond the poles");
}

TEST_F(Refusals, LatitudesInDisorder) {
  CurrentFile file;
  file.lats = {50.0, 52.0, 51.0};
  expect_refused_currents(file, "they rise, but 52 is followed by 51");
}

TEST_F(Refusals, DescendingLatitudesInDisorder) {
  CurrentFile file;
  file.lats = {52.0, 50.0, 51.0};
  expect_refused_currents(file, "they fall, but 50 is followed by 51");
}

TEST_F(Refusals, OneComponentAlone) {
  CurrentFile file;
  file.with_north = false;
  expect_refused_currents(file, "only one component");
}

TEST_F(Refusals, ComponentsAlongNominalAxesInTheFarNorth) {
  CurrentFile file;
  file.lats = {70.0, 75.0, 80.0};
  file.u_texts["standard_name"] = "sea_water_x_velocity";
  file.v_texts["standard_name"] = "sea_water_y_velocity";
  expect_refused_currents(file, "bent round poles on land");
}

TEST_F(Refusals, ComponentsThatAreDescribedDifferently) {
  CurrentFile file;
  file.u_texts["standard_name"] = "sea_water_x_velocity";
  expect_refused_currents(file, "described differently");
}

TEST_F(Refusals, TheWindInPlaceOfCurrents) {
  CurrentFile file;
  file.u_name = "u";
  file.v_name = "v";
  file.u_texts = {{"units", "m s-1"}, {"standard_name", "eastward_wind"}};
  file.v_texts = {{"units", "m s-1"}, {"standard_name", "northward_wind"}};
  file.write(path("wind.nc"));
  expect_refused(path("wind.nc"), "holds wind, not currents", {.kind = repository::DatasetKind::currents});
}

TEST_F(Refusals, LevelsThatAreNoDepths) {
  CurrentFile file;
  file.depths = {0.0, 1.0};
  file.depth_texts = {{"units", "dbar"}, {"standard_name", "depth"}};
  expect_refused_currents(file, "dbar");
}

TEST_F(Refusals, TablesOfPositionsThatSpanNoGrid) {
  {
    NetcdfWriter writer{path("nemo.nc")};
    writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20"}});
    writer.dimension("y", 2);
    writer.dimension("x", 2);
    const auto plane = [&](const std::string& name, std::map<std::string, std::string> texts) {
      writer.variable({.name = name,
                       .dimensions = {"y", "x"},
                       .values = {1.0, 2.0, 3.0, 4.0},
                       .texts = std::move(texts),
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    };
    plane("nav_lon", {{"units", "degrees_east"}});
    plane("nav_lat", {{"units", "degrees_north"}});
    for (const char* name : {"uo", "vo"})
      writer.variable({.name = name,
                       .dimensions = {"time", "y", "x"},
                       .values = {0.1, 0.1, 0.1, 0.1},
                       .texts = {{"units", "m/s"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
  }
  expect_refused(path("nemo.nc"), "mirrored or badly bent");
}

TEST_F(Refusals, DimensionsOfABillionBeforeAnythingIsAllocated) {
  {
    NetcdfWriter writer{path("huge.nc")};
    writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20"}});
    writer.dimension("lat", 1'000'000'000);
    writer.dimension("lon", 1'000'000'000);
    writer.variable({.name = "lat",
                     .dimensions = {"lat"},
                     .values = {},
                     .texts = {{"units", "degrees_north"}},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float32});
    for (const char* name : {"uo", "vo"})
      writer.variable({.name = name,
                       .dimensions = {"time", "lat", "lon"},
                       .values = {},
                       .texts = {{"units", "m/s"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float32});
  }
  expect_refused(path("huge.nc"), "more than this program accepts");
}

TEST_F(Refusals, AKindThatTheFileDoesNotHold) {
  CurrentFile{}.write(path("currents.nc"));
  expect_refused(path("currents.nc"), "not icebergs",
                 {.name = {}, .kind = repository::DatasetKind::icebergs, .crs = {}, .positive = {}});
}

TEST_F(Refusals, LeaveEarlierDatasetsAlone) {
  CurrentFile{}.write(path("good.nc"));
  ASSERT_EQ(ingest(path("good.nc")).status, IngestStatus::stored);
  CurrentFile bad;
  bad.with_north = false;
  expect_refused_currents(bad, "only one component");
  EXPECT_EQ(stored_datasets(), 1U);
}

}  // namespace
}  // namespace floeplan::ingest::refusals_test
