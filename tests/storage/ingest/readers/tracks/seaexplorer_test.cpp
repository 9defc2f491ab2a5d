#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"

namespace floeplan::ingest::seaexplorer_test {
namespace {

using testing::HasSubstr;

class Seaexplorer : public StoreFixture {
 protected:
  std::vector<ocean::GliderTrack> tracks() {
    std::vector<ocean::GliderTrack> all;
    for (const auto& found : repository::GliderTrackRepository{db_}.list({}, 0, 10).tracks)
      all.push_back(repository::GliderTrackRepository{db_}.find(found.row)->track);
    return all;
  }
  /// The report of a sample that is packed with gzip.
  IngestReport report_of_packed(const std::string& name) {
    return guarded_ingest(
               db_, {.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")},
               {sample_folder() / "glider" / name}, {}, core::from_unix_seconds(1.8e9), {}, {}, {})
        .front();
  }
};
const std::string navigation = "Timestamp;NavState;Heading;Depth;Lat;Lon;\n";

TEST_F(Seaexplorer, DivesBetweenItsFixesWhereItsFirmwareRepeatsTheLastOne) {
  const auto report = ingest(write_file(
      "sea035.6.gli.sub.1", navigation + "12/07/2018 21:01:17;105;332.7;0.1;0.000;0.000;\n"
                                         "17/05/2019 22:00:00;116;330.3;0.1;4839.000;-12327.000;\n"
                                         "17/05/2019 22:30:00;110;330.3;50.0;4839.000;-12327.000;\n"
                                         "17/05/2019 23:00:00;116;330.3;0.2;4839.600;-12326.400;\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto track = tracks().at(0);
  EXPECT_EQ(track.glider, "sea035");
  ASSERT_EQ(track.points.size(), 3U) << "the row without a fix is left out";
  EXPECT_EQ(core::iso8601(track.points[0].time), "2019-05-17T22:00:00Z");
  EXPECT_NEAR(track.points[0].place.lat_deg, 48.65, 1e-9);
  EXPECT_NEAR(track.points[0].place.lon_deg, -123.45, 1e-9);
  EXPECT_NEAR(track.points[1].place.lat_deg, 48.655, 1e-4) << "half way";
  EXPECT_FALSE(track.points[1].fixed);
  EXPECT_NEAR(track.points[1].depth->value, 50.0, 1e-9);
  EXPECT_TRUE(track.points[2].fixed);
}

TEST_F(Seaexplorer, LiesWhereItReckonsWhereItsFirmwareDoes) {
  const auto report = ingest(write_file(
      "sea035.6.gli.sub.1", navigation + "17/05/2019 22:00:00;116;330.3;0.1;4839.000;-12327.000;\n"
                                         "17/05/2019 22:30:00;110;330.3;50.0;4839.100;-12326.900;\n"
                                         "17/05/2019 23:00:00;116;330.3;0.2;4839.600;-12326.400;\n"));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_NEAR(tracks().at(0).points[1].place.lat_deg, 48.0 + 39.1 / 60.0, 1e-9);
}

TEST_F(Seaexplorer, OfAMissionIsOneTrackForItsNavigationAndOneForItsPayload) {
  const auto first =
      write_file("sea035.6.gli.sub.9", navigation + "17/05/2019 22:00:00;116;1;0.1;4839.0;-12327.0;\n");
  const auto second =
      write_file("sea035.6.gli.sub.10", navigation + "17/05/2019 23:00:00;116;1;0.1;4839.5;-12327.0;\n");
  const auto payload = write_file("sea035.6.pld1.sub.9",
                                  "PLD_REALTIMECLOCK;NAV_RESOURCE;NAV_LONGITUDE;NAV_LATITUDE;NAV_DEPTH;T;\n"
                                  "17/05/2019 22:00:01.500;116;-12327.0;4839.0;0.5;20.1;\n");
  const auto reports = ingest_all_together({second, payload, first});
  ASSERT_EQ(reports.size(), 2U);
  for (const auto& report : reports) EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
  ASSERT_EQ(tracks().size(), 2U);
  EXPECT_EQ(tracks()[0].points.size() + tracks()[1].points.size(), 3U);
}

TEST_F(Seaexplorer, WithoutPositionsOrFixesIsRefused) {
  expect_refused(write_file("sea035.6.pld1.sub.1", "PLD_REALTIMECLOCK;T;\n17/05/2019 22:00:01.500;20.1;\n"),
                 "needs time and position");
  expect_refused(
      write_file("sea035.6.gli.sub.1", navigation + "17/05/2019 22:00:00;105;1;0.1;0.000;0.000;\n"),
      "no position of the glider");
}

/// Places worked out by hand from the lines of c-proof/pyglider.
TEST_F(Seaexplorer, OfTheRealFilesIsRead) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto report = report_of_packed("sea035.6.gli.sub.1.gz");
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto track = tracks().at(0);
  EXPECT_EQ(core::iso8601(track.points.front().time), "2019-05-17T22:27:05Z");
  EXPECT_NEAR(track.points.front().place.lat_deg, 48.0 + 39.017 / 60.0, 1e-9);
  EXPECT_NEAR(track.points.front().place.lon_deg, -123.0 - 27.044 / 60.0, 1e-9);
  // At the surface only before the dive, so nothing tells where that took it.
  EXPECT_EQ(track.points.size(), 4U);
  EXPECT_THAT(words(report_of_packed("sea035.6.pld1.sub.1.gz")), HasSubstr("no position of the glider"));
}

}  // namespace
}  // namespace floeplan::ingest::seaexplorer_test
