#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::iceberg_table_test {
namespace {

using testing::HasSubstr;

class IcebergTable : public StoreFixture {
 protected:
  std::vector<ocean::Iceberg> stored(const IngestReport& report) {
    std::vector<ocean::Iceberg> result;
    if (!report.dataset) return result;
    for (const auto& sighting :
         repository::IcebergRepository{db_}.list({.dataset = report.dataset->id}, 0, 100'000))
      result.push_back(sighting.iceberg);
    return result;
  }

  ocean::Iceberg only(const std::string& table) {
    const IngestReport report = ingest(write_file("bergs.csv", table));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto bergs = stored(report);
    return bergs.empty() ? ocean::Iceberg{} : bergs.back();
  }
};

const std::string ice_center = "Iceberg,Length (NM),Width (NM),Latitude,Longitude,Area (sqMI),Last Update\n";

TEST_F(IcebergTable, OfTheIceCenterGivesLengthsInNauticalMiles) {
  const ocean::Iceberg berg = only(ice_center + "A81,28,25,-58.74,-49.94,518.07,08/27/2026\n");

  EXPECT_EQ(berg.id, "A81");
  EXPECT_EQ(berg.place, (geo::LonLat{-49.94, -58.74}));
  EXPECT_EQ(core::iso8601(berg.observed), "2026-08-27T00:00:00Z");
  EXPECT_EQ(berg.length, core::Metres{28.0 * 1852.0});
  EXPECT_EQ(berg.size, ocean::IcebergSize::very_large);
}

TEST_F(IcebergTable, LeavesOutAndCountsRowsThatCannotBe) {
  const IngestReport report = ingest(write_file(
      "bergs.csv", ice_center + "A1,12,7,-53.7,-29.5,1,08/27/2026\nA2,12,7,-95,-29.5,1,08/27/2026\n"
                                "A3,12,7,-53.7,-29.5,1,13/45/2026\nA4,999,7,-53.7,-29.5,1,08/27/2026\n"
                                "A5,12,7,-53.7,-29.5,1,08/27/2026,,,\nA6,12,7,-5"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, 2);
  EXPECT_EQ(report.dataset->rows_refused, 4);
  EXPECT_THAT(words(report), HasSubstr("cut short"));
}

TEST_F(IcebergTable, OfATrackBelievesWhatWasSeenBeforeWhatWasInterpolatedAndCarriesTheSizeOn) {
  const IngestReport report =
      ingest(write_file("b99.csv",
                        "ascat_1,ascat_2,ascat_3,date,nic_1,nic_2,nic_3,size_1,size_2\n"
                        "-60.5,-50.5,1,2021147,-60.6,-50.6,1,20,12\n"
                        "-61.5,-51.5,0,2021148,-61.6,-51.6,1,0,0\n"
                        "-62.5,-52.5,0,2021149,0,0,0,0,0\n"
                        "0,0,0,2021150,0,0,0,0,0\n"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto bergs = stored(report);
  ASSERT_EQ(bergs.size(), 3U);
  EXPECT_EQ(report.dataset->rows_refused, 1);
  EXPECT_EQ(bergs[0].id, "b99");
  EXPECT_EQ(bergs[0].place, (geo::LonLat{-50.5, -60.5}));
  EXPECT_EQ(bergs[0].method, "ascat");
  EXPECT_EQ(core::iso8601(bergs[0].observed), "2021-05-27T00:00:00Z");
  EXPECT_EQ(bergs[1].place, (geo::LonLat{-51.6, -61.6}));
  EXPECT_EQ(bergs[1].method, "nic");
  EXPECT_EQ(bergs[2].method, "ascat interpolated");
  for (const ocean::Iceberg& berg : bergs) EXPECT_EQ(berg.length, core::Metres{20.0 * 1852.0});
}

TEST_F(IcebergTable, OfABeaconGivesTheAccuracyOfItsArgosClass) {
  const ocean::Iceberg berg = only(
      ",beacon_id,datetime_data,latitude,longitude,loc_accuracy\n0,1997_1,1997-08-16 "
      "07:07:00+00:00,64.51,-59.797,3\n");

  EXPECT_EQ(berg.id, "1997_1");
  EXPECT_EQ(core::iso8601(berg.observed), "1997-08-16T07:07:00Z");
  EXPECT_EQ(berg.position_uncertainty, core::Metres{250.0});
}

TEST_F(IcebergTable, IsStoredOrRefusedAtAnyLengthButNeverHalfARow) {
  const std::string whole =
      ice_center + "A76C,16,7,-53.73,-29.5,112.44,08/27/2026\nA81,28,25,-58.74,-49.94,518.07,08/27/2026\n";
  for (std::size_t twentieth = 1; twentieth < 20; ++twentieth) {
    const IngestReport report = ingest(write_file("cut.csv", whole.substr(0, whole.size() * twentieth / 20)));
    for (const ocean::Iceberg& berg : stored(report)) {
      EXPECT_TRUE(berg.id == "A76C" || berg.id == "A81");
      EXPECT_LT(berg.place.lat_deg, -50.0) << twentieth;
    }
  }
}

/// The values that an independent reader finds in a sample.
struct Expected {
  std::string file;
  std::int64_t rows;
  std::int64_t refused;
  std::string last_id;
  geo::LonLat last_place;
  std::string last_time;
  std::optional<double> last_length_m;
};

TEST_F(IcebergTable, OfEverySampleHoldsWhatAnotherReaderFinds) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const double nm = 1852.0;
  for (const Expected& expected : std::vector<Expected>{
           {"usnic_sample_rows.csv", 5, 0, "A85", {-53.38, -62.85}, "2026-08-27T00:00:00Z", 10.0 * nm},
           {"usnic_sample_rows_old_schema.csv",
            3,
            0,
            "D30B",
            {-70.05, -70.05},
            "2022-12-09T00:00:00Z",
            10.0 * nm},
           {"cis_beacon_1997_12995.csv", 639, 1, "1997_12995", {-62.381, 64.238}, "1997-10-03T19:41:00Z", {}},
           {"byu_latest_20260818.json",
            38,
            0,
            "uk324",
            {148.0 + 46.0 / 60.0, -67.0 - 2.0 / 60.0},
            "2026-08-16T00:00:00Z",
            10.0 * nm},
           {"byu_consol_v5/a01.csv", 100, 0, "a01", {-26.3, -50.2}, "1979-05-06T00:00:00Z", 20.0 * nm},
           {"byu_consol_v5/a04.csv", 1, 0, "a04", {-30.8, -54.2}, "1979-10-21T00:00:00Z", 30.0 * nm},
           {"byu_consol_v5/a68a.csv",
            1324,
            0,
            "a68a",
            {-33.0103, -52.6505},
            "2021-04-21T00:00:00Z",
            3.0 * nm},
           {"byu_consol_v5/a76a.csv",
            334,
            0,
            "a76a",
            {-55.7658, -67.5713},
            "2022-04-25T00:00:00Z",
            73.0 * nm},
           {"byu_consol_v5/b15a.csv",
            3205,
            0,
            "b15a",
            {-147.3878, -53.3464},
            "2009-03-27T00:00:00Z",
            40.0 * nm},
           {"byu_consol_v5/c19a.csv",
            2153,
            0,
            "c19a",
            {-98.4025, -58.9026},
            "2009-04-01T00:00:00Z",
            68.0 * nm},
           {"byu_consol_v5/d28.csv", 946, 0, "d28", {-32.3868, -74.5266}, "2022-04-25T00:00:00Z", 29.0 * nm},
           {"byu_consol_v5/uk323.csv", 217, 0, "uk323", {132.2902, -65.4971}, "2015-07-12T00:00:00Z", {}}}) {
    const IngestReport report = ingest(sample_folder() / "icebergs" / expected.file);
    ASSERT_EQ(report.status, IngestStatus::stored) << expected.file << words(report);
    EXPECT_EQ(report.dataset->rows_accepted, expected.rows) << expected.file;
    EXPECT_EQ(report.dataset->rows_refused, expected.refused) << expected.file;
    const ocean::Iceberg last = stored(report).back();
    EXPECT_EQ(last.id, expected.last_id) << expected.file;
    EXPECT_NEAR(last.place.lon_deg, expected.last_place.lon_deg, 1e-9) << expected.file;
    EXPECT_NEAR(last.place.lat_deg, expected.last_place.lat_deg, 1e-9) << expected.file;
    EXPECT_EQ(core::iso8601(last.observed), expected.last_time) << expected.file;
    ASSERT_EQ(last.length.has_value(), expected.last_length_m.has_value()) << expected.file;
    EXPECT_NEAR(last.length.value_or(core::Metres{0.0}).value, expected.last_length_m.value_or(0.0), 1e-6)
        << expected.file;
  }
}

TEST_F(IcebergTable, OfTheOldIceCenterKeepsThatABergIsAground) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const IngestReport report = ingest(sample_folder() / "icebergs/usnic_sample_rows_old_schema.csv");
  const auto bergs = stored(report);
  ASSERT_EQ(bergs.size(), 3U);
  EXPECT_EQ(bergs[0].shape, "grounded");
  EXPECT_EQ(bergs[1].shape, "");
}

}  // namespace
}  // namespace floeplan::ingest::iceberg_table_test
