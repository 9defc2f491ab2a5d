#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/iceberg_csv_reader.hpp"
#include "storage/repository/iceberg_repository.hpp"
#include "tests/storage/ingest/store_fixture.hpp"

namespace floeplan::ingest {
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
  ingest_rows("2014,1,1/1/2014,0000,50,-50,VIS,GEN,GEN,A\n2014,2,1/1/2014,0,50,-50,RAD,RAD,RAD,A\n");

  ASSERT_EQ(sightings().size(), 2U);
  EXPECT_EQ(sightings()[0].iceberg.size, ocean::IcebergSize::unknown);
  EXPECT_EQ(sightings()[1].iceberg.size, ocean::IcebergSize::radar_target);
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
  EXPECT_THAT(report.warnings.back(), HasSubstr("15 more rows"));
}

TEST_F(IcePatrolCsv, AFileWithoutAnyGoodRowIsRefused) {
  expect_refused(write_file("bergs.csv", std::string{header} + "bad,row\n"), "no usable sighting");
  expect_refused(write_file("bergs.csv", header), "no usable sighting");
}

TEST(CsvFields, KeepQuotedCommas) {
  EXPECT_THAT(csv_fields(R"(a,"b, c",,"say ""ice""")"), ElementsAre("a", "b, c", "", R"(say "ice")"));
}

}  // namespace
}  // namespace floeplan::ingest
