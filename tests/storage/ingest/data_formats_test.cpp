#include "storage/ingest/data_formats.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "storage/ingest/format_of.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/written_out.hpp"

namespace floeplan::ingest::data_formats_test {
namespace {

using namespace std::string_literals;
using repository::DatasetKind;
using testing::HasSubstr;

/// The shortest beginning of a file by which each format is recognised; nothing for folders.
const std::map<std::string, std::string>& beginnings() {
  static const std::map<std::string, std::string> all{
      {"NetCDF", "\x89HDF\r\n\x1a\n" + std::string(64, '\0')},
      {"GRIB2", "GRIB\0\0\0\2"s},
      {"GeoTIFF", "II*\0"s},
      {"GeoPackage", "SQLite format 3" + std::string(53, '\0') + "GPKG\0"s},
      {"shapefile", "\x00\x00\x27\x0a"s},
      {"S-57", "015623LE1 0900201 ! 34040000"},
      {"TCD",
       "[VERSION] = PFM Software - libtcd v2.2.7\n[NUMBER OF RECORDS] = 1\n[CONSTITUENTS] = 37\n[END OF "
       "FILE] = 90\n"},
      {"GeoJSON", R"({"type": "FeatureCollection", "features": []})"},
      {"NOAA's JSON", R"({"HarmonicConstituents": []})"},
      {"KML", "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"/>"},
      {"S-411", "<?xml version=\"1.0\"?><ice:IceDataSet xmlns:ice=\"http://www.jcomm.info/ice\"/>"},
      {"ESRI ASCII", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n"},
      {"International Ice Patrol",
       "ICEBERG_YEAR,ICEBERG_NUMBER,SIGHTING_DATE,SIGHTING_TIME,SIGHTING_LATITUDE,SIGHTING_LONGITUDE,"
       "SIGHTING_METHOD,SIZE,SHAPE\n"},
      {"table of your own", "id,lat,lon,time\n"},
      {"Seaglider", "version: 66.11\nrevision: 1138\nglider: 561\nmission: 6\ndive: 5\n"},
      {"SeaExplorer", "Timestamp;NavState;Depth;Lat;Lon;\n"},
      {"ADCIRC", "run 1\n2 4 3600.0 3600 2\n3600.0 3600\n1 0.1 0.2\n"},
      {"XYZ", "-52.0 69.0 -120\n-51.9 69.0 -130\n"},
      {"grid of depths", "lon,lat,depth\n"}};
  return all;
}

TEST(DataFormats, HaveANameOfTheirOwnAReaderAndKinds) {
  std::set<std::string_view> names;
  for (const DataFormat& format : data_formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_NE(format.is_it, nullptr) << format.name;
    EXPECT_NE(format.read, nullptr) << format.name;
    EXPECT_FALSE(format.reads.empty()) << format.name;
    EXPECT_FALSE(format.tested_with.empty()) << format.name;
    EXPECT_TRUE(format.kinds.size() == 1 || (format.look_into != nullptr && !format.kinds.empty()))
        << format.name << " has to say which of its kinds a file holds";
  }
}

TEST(DataFormats, HoldEveryKindOfDataBetweenThem) {
  for (const DatasetKind kind :
       {DatasetKind::bathymetry, DatasetKind::currents, DatasetKind::wind, DatasetKind::ice,
        DatasetKind::icebergs, DatasetKind::coastline, DatasetKind::tides, DatasetKind::water_levels,
        DatasetKind::zones, DatasetKind::glider_tracks})
    EXPECT_TRUE(std::ranges::any_of(data_formats(), [&](const DataFormat& format) {
      return std::ranges::find(format.kinds, kind) != format.kinds.end();
    })) << repository::kind_name(kind);
}

TEST(DataFormats, AreTheTableOfTheGuide) {
  std::string table = "| format | kinds of data | what is read | tested with |\n|---|---|---|---|\n";
  for (const DataFormat& format : data_formats()) {
    std::string kinds;
    for (const DatasetKind kind : format.kinds)
      kinds += (kinds.empty() ? "" : ", ") + repository::kind_name(kind);
    table += "| " + std::string{format.name} + " | " + kinds + " | " + std::string{format.reads} + " | " +
             std::string{format.tested_with} + " |\n";
  }

  support::expect_written_part("web/guide/data.md", "formats", table, "ingest_test");
}

class FormatOf : public StoreFixture {};

TEST_F(FormatOf, AFileIsTheRowThatItsFirstBytesAreOfWhateverItsName) {
  for (const auto& [name, beginning] : beginnings()) {
    const auto format = format_of(write_file("data.bin", beginning));
    ASSERT_TRUE(format) << name << ": " << reason_of(format.error());
    EXPECT_EQ((*format)->name, name);
  }
}

TEST_F(FormatOf, ABagIsWalkedThroughBeforeAnythingOpensIt) {
  const auto format =
      format_of(write_file("bag.nc", "\x89HDF\r\n\x1a\n" + std::string(64, '\0') + "BAG_root"));

  ASSERT_FALSE(format);
  EXPECT_THAT(reason_of(format.error()), HasSubstr("cannot be read to its end"));
}

// If a table was cut short within its last number, the rest is another number. So a missing line end is
// reported for every format of lines.
TEST_F(FormatOf, ATextOfRowsHasLines) {
  for (const DataFormat& format : data_formats())
    EXPECT_EQ(format.has_lines, format.writing == Writing::text && format.together == Together::none)
        << format.name;
}

}  // namespace
}  // namespace floeplan::ingest::data_formats_test
