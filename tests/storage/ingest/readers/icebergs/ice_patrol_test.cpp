#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::ice_patrol_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* header = "ICE-YEAR,BERG_NUMBER,DATE,TIME,LATITUDE,LONGITUDE,METHOD,SIZE,SHAPE,SOURCE\n";

class IcePatrolCsv : public StoreFixture {
 protected:
  IngestReport ingest_rows(const std::string& rows) { return ingest(write_file("bergs.csv", header + rows)); }
  std::vector<repository::StoredSighting> sightings() {
    return repository::IcebergRepository{db_}.list({}, 0, 100);
  }
};

TEST_F(IcePatrolCsv, ReadsARowIntoASighting) {
  const auto report = ingest_rows("2014,1,10/7/2013,0815,60.46,-63.51,SAT-HIGH,VLG,TAB,RSA2\r\n");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  ASSERT_EQ(sightings().size(), 1U);
  const ocean::Iceberg berg = sightings().front().iceberg;
  EXPECT_EQ(berg.id, "2014-1");
  EXPECT_EQ(core::iso8601(berg.observed), "2013-10-07T08:15:00Z");
  EXPECT_EQ(berg.place, (geo::LonLat{-63.51, 60.46}));
  EXPECT_EQ(berg.size, ocean::IcebergSize::very_large);
  EXPECT_EQ(berg.shape, "TAB");
  EXPECT_EQ(berg.method, "SAT-HIGH");
  EXPECT_FALSE(berg.length.has_value());
}

TEST_F(IcePatrolCsv, AnUnknownSizeAndARadarTargetAreNeverSmall) {
  ingest_rows(
      "2014,1,1/1/2014,0000,50,-50,VIS,GEN,GEN,A\n2014,2,1/1/2014,0,50,-50,RAD,RAD,RAD,A\n"
      "2014,3,1/1/2014,0,50,-50,VIS,UNK,UNK,A\n");

  ASSERT_EQ(sightings().size(), 3U);
  EXPECT_EQ(sightings()[0].iceberg.size, ocean::IcebergSize::unknown);
  EXPECT_EQ(sightings()[1].iceberg.size, ocean::IcebergSize::radar_target);
  EXPECT_EQ(sightings()[2].iceberg.size, ocean::IcebergSize::unknown);
}

TEST_F(IcePatrolCsv, ColumnsAreFoundByTheirNames) {
  const auto report = ingest(write_file("bergs.csv",
                                        "SHAPE,SIZE,METHOD,LONGITUDE,LATITUDE,TIME,DATE,BERG_NUMBER,ICE-"
                                        "YEAR\nTAB,SM,VIS,-50,48.5,1200,3/4/2014,7,2014\n"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(sightings().front().iceberg.place, (geo::LonLat{-50.0, 48.5}));
}

TEST_F(IcePatrolCsv, BadRowsAreLeftOutCountedAndExplained) {
  const auto report = ingest_rows(
      "2014,1,10/7/2013,2139,60.46,-63.51,VIS,SM,TAB,A\n2014,2,2/30/"
      "2014,2139,60.46,-63.51,VIS,SM,TAB,A\n2014,3,10/7/2013,2461,60.46,-63.51,VIS,SM,TAB,A\n2014,4,10/7/"
      "2013,2139,95,-63.51,VIS,SM,TAB,A\n2014,5,10/7/2013,2139,sixty,-63.51,VIS,SM,TAB,A\n2014,6,10/7/"
      "2013,2139,60.46,-63.51,VIS,HUGE,TAB,A\n2014,7,10/7/2013,2139,60.");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, 1);
  EXPECT_EQ(report.dataset->rows_refused, 6);
  EXPECT_THAT(words(report), HasSubstr("line 3 was left out"));
  EXPECT_THAT(words(report), HasSubstr("\"2/30/2014 2139\""));
  EXPECT_THAT(words(report), HasSubstr("\"HUGE\""));
  EXPECT_THAT(words(report), HasSubstr("line 8 was left out: it has 5 fields"));
}

TEST_F(IcePatrolCsv, OnlyTheFirstTenBadRowsAreExplained) {
  std::string rows = "2014,1,10/7/2013,2139,60.46,-63.51,VIS,SM,TAB,A\n";
  for (int i = 0; i < 25; ++i) rows += "bad,row\n";

  const auto report = ingest_rows(rows);

  EXPECT_EQ(report.dataset->rows_refused, 25);
  EXPECT_EQ(report.warnings.size(), 11U);
  EXPECT_THAT(messages::sentence(report.warnings.back()), HasSubstr("15 more rows"));
}

TEST_F(IcePatrolCsv, AFileWithoutAnyGoodRowIsRefused) {
  expect_refused(write_file("bergs.csv", std::string{header} + "bad,row\n"), "no usable sighting");
  expect_refused(write_file("bergs.csv", header), "no usable sighting");
}

TEST_F(IcePatrolCsv, KnowsTheColumnsOfItsLaterYears) {
  const auto report = ingest(write_file("bergs.csv",
                                        "ICEBERG_YEAR,ICEBERG_NUMBER,SIGHTING_DATE,SIGHTING_TIME,SIGHTING_"
                                        "LATITUDE,SIGHTING_LONGITUDE,SIGHTING_METHOD,"
                                        "SIZE,SHAPE,SOURCE\n2021,12,2021-03-04,815,48.52,-49.33,VIS,MED,DRY,"
                                        "IIP\n2021,13,3/5/2021,1240,48.02,-48.33,RAD,"
                                        "RAD,UNK,IIP\n"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  ASSERT_EQ(sightings().size(), 2U);
  EXPECT_EQ(sightings().front().iceberg.id, "2021-12");
  EXPECT_EQ(core::iso8601(sightings().front().iceberg.observed), "2021-03-04T08:15:00Z");
}

class OwnIcebergTable : public IcePatrolCsv {};

TEST_F(OwnIcebergTable, IsReadByTheNamesOfItsColumns) {
  for (const char* table : {"id,lat,lon,time,length_m,draft_m,position_uncertainty_m,size\nA1,69.1,-52.2,"
                            "2026-11-22T03:00:00Z,120,80,340,medium\n",
                            "Berg;Longitude;Latitude;Time (UTC);Length (m);Draft (m);Position uncertainty "
                            "(m);Size\r\nA1;-52,2;69,1;2026-11-22 "
                            "03:00;120;80;340;Medium\r\n",
                            "\"name\"\t\"latitude\"\t\"longitude\"\t\"observed\"\t\"length_m\"\t\"draft_"
                            "m\"\t\"position_uncertainty_m\"\t\"size\"\nA1\t69."
                            "1\t-52.2\t"
                            "2026-11-22T00:00:00-03:00\t120\t80\t340\tmedium\n"}) {
    SCOPED_TRACE(table);
    const auto report = ingest(write_file("bergs.csv", table));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const ocean::Iceberg berg = sightings().back().iceberg;
    EXPECT_EQ(berg.id, "A1");
    EXPECT_EQ(berg.place, (geo::LonLat{-52.2, 69.1}));
    EXPECT_EQ(core::iso8601(berg.observed), "2026-11-22T03:00:00Z");
    EXPECT_EQ(berg.length, core::Metres{120.0});
    EXPECT_EQ(berg.draft, core::Metres{80.0});
    EXPECT_EQ(berg.position_uncertainty, core::Metres{340.0});
    EXPECT_EQ(berg.size, ocean::IcebergSize::medium);
  }
}

TEST_F(OwnIcebergTable, LeavesOutBadRowsWithTheirReasons) {
  const auto report = ingest(write_file("bergs.csv",
                                        "id,lat,lon,time,length_m\n"
                                        "good,69.1,-52.2,2026-11-22T03:00:00Z,\n"
                                        ",69.1,-52.2,2026-11-22T03:00:00Z,120\n"
                                        "place,69.1 N,-52.2,2026-11-22T03:00:00Z,120\n"
                                        "pole,99.1,-52.2,2026-11-22T03:00:00Z,120\n"
                                        "zone,69.1,-52.2,2026-11-22 03:00,120\n"
                                        "length,69.1,-52.2,2026-11-22,-5\n"
                                        "fields,69.1,-52.2\n"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, 1);
  EXPECT_EQ(report.dataset->rows_refused, 6);
  EXPECT_THAT(words(report), HasSubstr("with its zone; in UTC, call the column time_utc"));
  EXPECT_THAT(words(report), HasSubstr("length_m is \"-5\""));
}

TEST_F(OwnIcebergTable, MayHaveNoLengthsAtAll) {
  for (const char* const table :
       {"id,lat,lon,time\nB1,48.1,-50.1,2026-03-01T00:00:00Z\n",
        "id,lat,lon,time_utc,position_uncertainty_m\nB1,48.1,-50.1,2026-03-01T00:00:00Z,500\n"}) {
    const auto report = ingest(write_file("bergs.csv", table));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const ocean::Iceberg berg = sightings().back().iceberg;
    EXPECT_EQ(berg.place, (geo::LonLat{-50.1, 48.1}));
    EXPECT_FALSE(berg.length);
    EXPECT_EQ(berg.size, ocean::IcebergSize::unknown);
    EXPECT_THAT(words(report), HasSubstr("every row counts as an iceberg of unknown size"));
  }
}

TEST_F(OwnIcebergTable, IsWhatTheUserSaysThatItIs) {
  const std::string drone = "name,lat,lon,time,battery\nB1,48.1,-50.1,2026-03-01T00:00:00Z,80\n";
  expect_refused(write_file("drone.csv", drone), "columns");

  const auto report = ingest(write_file("drone.csv", drone), {.kind = repository::DatasetKind::icebergs});

  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

TEST_F(OwnIcebergTable, HasLengthsInTheUnitThatItsColumnNames) {
  struct Unit {
    const char* column;
    double metres;
  };
  support::for_each_seed(24, [&](std::mt19937_64& rng) {
    constexpr std::array units{Unit{"length_m", 1.0},        Unit{"Length (ft)", 0.3048},
                               Unit{"length (nm)", 1852.0},  Unit{"length_km", 1000.0},
                               Unit{"length_yards", 0.9144}, Unit{"length_fathoms", 1.8288}};
    const Unit unit = units.at(static_cast<std::size_t>(support::uniform_int(rng, 0, 5)));
    const int length = support::uniform_int(rng, 1, 100);
    const auto report =
        ingest(write_file("bergs.csv", std::string{"id,lat,lon,time,"} + unit.column +
                                           "\nA1,69.1,-52.2,2026-11-22," + std::to_string(length) + "\n"));

    ASSERT_TRUE(report.dataset) << words(report);
    ASSERT_TRUE(sightings().back().iceberg.length);
    EXPECT_NEAR(sightings().back().iceberg.length->value, length * unit.metres, 1e-6);
  });
}

/// Law: the position error is read from every known name of the column and its unit.
TEST_F(OwnIcebergTable, KnowsAnErrorOfThePositionByItsWords) {
  constexpr std::array names{"position_uncertainty",
                             "position_error",
                             "uncertainty",
                             "accuracy",
                             "error",
                             "pos_err",
                             "poserr",
                             "position_accuracy",
                             "error_radius",
                             "Location error",
                             "locAccuracy",
                             "POS_ERR",
                             "Position precision",
                             "position_sigma",
                             "horiz_uncert",
                             "estimated position error"};
  struct Unit {
    const char* name;
    double metres;
  };
  constexpr std::array units{Unit{"_m", 1.0}, Unit{" (km)", 1000.0}, Unit{"_nm", 1852.0},
                             Unit{" [ft]", 0.3048}, Unit{" nautical miles", 1852.0}};
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const std::string name =
        names.at(static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(names.size()) - 1)));
    const Unit unit =
        units.at(static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(units.size()) - 1)));
    const int error = support::uniform_int(rng, 0, 100);
    SCOPED_TRACE(name + unit.name);
    const auto report =
        ingest(write_file("bergs.csv", "id,lat,lon,time,length_m," + name + unit.name +
                                           "\nA1,69.1,-52.2,2026-11-22,100," + std::to_string(error) + "\n"));

    ASSERT_TRUE(report.dataset) << words(report);
    ASSERT_TRUE(sightings().back().iceberg.position_uncertainty);
    EXPECT_NEAR(sightings().back().iceberg.position_uncertainty->value, error * unit.metres, 1e-6);
    EXPECT_THAT(words(report), testing::Not(HasSubstr("may be the position error")));
  });
}

TEST_F(OwnIcebergTable, TellsOfAnErrorThatItDoesNotUnderstand) {
  for (const char* name : {"radius_m", "Accuracy", "position_error", "lat_error_deg", "length_error_m"}) {
    const auto report = ingest(write_file("bergs.csv", std::string{"id,lat,lon,time,length_m,"} + name +
                                                           "\nA1,69.1,-52.2,2026-11-22,100,4000\n"));

    ASSERT_TRUE(report.dataset) << words(report);
    EXPECT_THAT(words(report), HasSubstr('"' + std::string{name} + "\" may be the position error"));
    EXPECT_FALSE(sightings().back().iceberg.position_uncertainty);
  }
}

TEST_F(OwnIcebergTable, TakesTheLargestOfSeveralErrors) {
  const auto report = ingest(write_file("bergs.csv",
                                        "id,lat,lon,time,length_m,accuracy_m,position_error_km\n"
                                        "A1,69.1,-52.2,2026-11-22,100,300,4\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(sightings().back().iceberg.position_uncertainty, core::Metres{4000.0});
}

TEST_F(IcePatrolCsv, KnowsAnErrorOfThePosition) {
  const auto report =
      ingest(write_file("bergs.csv",
                        "ICE-YEAR,BERG_NUMBER,DATE,TIME,LATITUDE,LONGITUDE,METHOD,SIZE,SHAPE,POS_ERR_NM\n"
                        "2014,1,10/7/2013,0815,60.46,-63.51,SAT,VLG,TAB,2\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(sightings().back().iceberg.position_uncertainty, core::Metres{3704.0});
}

TEST_F(OwnIcebergTable, TellsOfALengthWithoutAUnit) {
  const auto report =
      ingest(write_file("bergs.csv", "berg,lat,lon,time,length\nA1,69.1,-52.2,2026-11-22,2\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("\"length\" was not read"));
}

TEST_F(OwnIcebergTable, NeedsNoStatedKindForALengthWithoutAUnitBesideAnId) {
  const auto report =
      ingest(write_file("bergs.csv", "id,lat,lon,time,length\nB1,69.1,-53.0,2026-11-21T12:00:00Z,120\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_FALSE(sightings().back().iceberg.length);
  EXPECT_THAT(words(report), HasSubstr("\"length\" was not read"));
}

TEST_F(OwnIcebergTable, OfAShipsTrackOrOfAnUnknownUnitIsNotTakenForOne) {
  expect_refused(write_file("cables.csv", "id,lat,lon,time,length (cables)\nA1,69.1,-52.2,2026-11-22,2\n"),
                 "columns");
  expect_refused(write_file("track.csv", "name,lat,lon,time\nship,69.1,-52.2,2026-11-22T03:00:00Z\n"),
                 "columns");
}

TEST(CsvFields, KeepQuotedCommas) {
  EXPECT_THAT(csv_fields(R"(a,"b, c",,"say ""ice""")"), ElementsAre("a", "b, c", "", R"(say "ice")"));
}

}  // namespace
}  // namespace floeplan::ingest::ice_patrol_test
