#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"

namespace floeplan::ingest::seaglider_test {
namespace {

using testing::HasSubstr;

class Seaglider : public StoreFixture {
 protected:
  ocean::GliderTrack track_of(const IngestReport& report) {
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto found = repository::GliderTrackRepository{db_}.list({}, 0, 2);
    if (found.tracks.size() != 1) throw std::runtime_error{words(report)};
    return repository::GliderTrackRepository{db_}.find(found.tracks.front().row)->track;
  }
  static std::string log(int dive, const std::string& lines) {
    return "version: 67.01\nrevision: 1138\nglider: 561\nmission: 6\ndive: " + std::to_string(dive) +
           "\nstart: 5 4 116 20 33 7\ndata:\n$ID,561\n" + lines;
  }
};

const std::string fixes =
    "$GPS1,040516,203002,7017.131,838.117,29,1.3,29,1.1\n$GPS2,040516,203244,7017.119,838.198,20,1.3,20,1.1\n"
    "$GPS_DEVICE,32\n$GPS,040516,215253,7016.197,839.033,41,1.2,41,1.1\n";

constexpr double start_s = 1'462'393'987.0;  // 2016-05-04T20:33:07Z

TEST_F(Seaglider, HasTheFixesOfItsLogAndTheCurrentTowardsWhereItFlows) {
  const auto report = ingest(write_file("p5610005.log", log(5, fixes + "$CURRENT,0.250, 90.0,1\n")));
  const auto track = track_of(report);

  EXPECT_EQ(track.glider, "sg561");
  ASSERT_EQ(track.points.size(), 3U);
  EXPECT_EQ(core::unix_seconds(track.points[0].time), 1'462'393'802.0);
  EXPECT_NEAR(track.points[0].place.lat_deg, 70.0 + 17.131 / 60.0, 1e-9);
  EXPECT_NEAR(track.points[0].place.lon_deg, 8.0 + 38.117 / 60.0, 1e-9);
  ASSERT_EQ(track.currents.size(), 1U);
  EXPECT_NEAR(track.currents[0].current.east.value, 0.25, 1e-9) << "90 degrees is towards the east";
  EXPECT_NEAR(track.currents[0].current.north.value, 0.0, 1e-9);
  EXPECT_EQ(core::unix_seconds(track.currents[0].time), 0.5 * (1'462'393'964.0 + 1'462'398'773.0));
  EXPECT_THAT(words(report), HasSubstr("vehicle's own estimate"));
}

TEST_F(Seaglider, HasNoCurrentWhereTheVehicleCallsItInvalidOrHasNone) {
  EXPECT_TRUE(
      track_of(ingest(write_file("a.log", log(5, fixes + "$CURRENT,0.250, 90.0,0\n")))).currents.empty());
}

TEST_F(Seaglider, LeavesOutFixesThatAreNone) {
  const auto report = ingest(write_file(
      "p5610005.log", log(5,
                          "$GPS1,040516,203002,0.000,0.000,29,1.3,29,1.1\n"
                          "$GPS2,040516,203244,7017.119,838.198,99,99.0,99,1.1\n"
                          "$GPS1,190996,203002,7017.131,838.117,29,1.3,29,1.1\n"  // 1024 weeks too early
                          "$GPS,040516,215253,7016.197,839.033,41,1.2,41,1.1\n")));
  EXPECT_EQ(track_of(report).points.size(), 1U);
  EXPECT_EQ(report.dataset->rows_refused, 3);
}

TEST_F(Seaglider, HasTheDepthsOfItsRecordBetweenItsFixes) {
  const auto record =
      write_file("p5610005.eng",
                 "%version: 66.11\n%glider: 561\n%mission: 6\n%dive: 5\n%start: 05 04 116 20 33 07\n"
                 "%columns: elaps_t_0000,elaps_t,depth,head\n%data:\n"
                 "74029.7 42.5 248.000 213.4\n75829.7 1842.5 30845.000 213.4\n75859.7 NaN NaN 213.4\n");
  expect_refused(record, "no positions");
  const auto report = ingest_together({record, write_file("p5610005.log", log(5, fixes))});
  const auto track = track_of(report);

  ASSERT_EQ(track.points.size(), 5U);
  EXPECT_EQ(core::unix_seconds(track.points[2].time), start_s + 42.5);
  EXPECT_NEAR(track.points[2].depth->value, 2.48, 1e-9) << "centimetres";
  EXPECT_NEAR(track.points[3].depth->value, 308.45, 1e-9);
  EXPECT_FALSE(track.points[3].fixed);
  EXPECT_LT(track.points[3].place.lat_deg, track.points[1].place.lat_deg);
  EXPECT_GT(track.points[3].place.lat_deg, track.points[4].place.lat_deg);
}

TEST_F(Seaglider, OfOneMissionIsOneTrackHoweverItsDivesAreGiven) {
  const auto second = write_file("p5610006.log", log(6,
                                                     "$GPS1,040516,215253,7016.197,839.033,41,1.2,41,1.1\n"
                                                     "$GPS2,040516,215600,7016.200,839.040,41,1.2,41,1.1\n"
                                                     "$GPS,040516,231000,7015.000,840.000,41,1.2,41,1.1\n"));
  const auto reports = ingest_all_together({second, write_file("p5610005.log", log(5, fixes))});
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(track_of(reports.front()).points.size(), 5U) << "the fix between the dives is one";
}

TEST_F(Seaglider, ThatWasCutInItsHeadIsRefused) {
  expect_refused(write_file("a.log", "version: 66.11\nglider: 561\ndive: 5\nstart: 5 4 116\ndata:\n" + fixes),
                 "do not state the glider");
  expect_refused(write_file("b.log", log(5, "$N_DIVES,0\n")), "no position of the glider");
}

/// The fixes and depths as plain Python finds them in the files of iop-apl-uw/basestation3.
TEST_F(Seaglider, OfTheRealDiveReadsAsAnotherReaderDoes) {
  const auto log_file = sample_folder().parent_path() / "live/seaglider_p5610005_2016.log";
  if (sample_folder().empty() || !std::filesystem::exists(log_file))
    GTEST_SKIP() << "the sample files are not here";
  const auto track = track_of(ingest_together({sample_folder() / "glider/seaglider_p5610005.eng", log_file}));
  EXPECT_EQ(track.points.size(), 3U + 155U);
  EXPECT_EQ(core::unix_seconds(track.points.front().time), 1'462'393'802.0);
  EXPECT_EQ(core::unix_seconds(track.points.back().time), 1'462'398'773.0);
  EXPECT_NEAR(track.points.back().place.lat_deg, 70.26995, 1e-9);
  EXPECT_NEAR(track.points.back().place.lon_deg, 8.65055, 1e-9);
  double deepest_m = 0.0;
  for (const auto& point : track.points)
    if (point.depth) deepest_m = std::max(deepest_m, point.depth->value);
  EXPECT_NEAR(deepest_m, 308.45, 1e-9);
}

TEST_F(Seaglider, OfFirmware67HasTheCurrentOfItsLog) {
  const auto log_file = sample_folder().parent_path() / "live/seaglider_p2720002_2026.log";
  if (sample_folder().empty() || !std::filesystem::exists(log_file))
    GTEST_SKIP() << "the sample files are not here";
  const auto track = track_of(ingest(log_file));
  ASSERT_EQ(track.currents.size(), 1U);
  EXPECT_NEAR(track.currents[0].current.east.value, 0.138 * std::sin(12.9 * std::numbers::pi / 180.0), 1e-9);
  EXPECT_NEAR(track.currents[0].current.north.value, 0.138 * std::cos(12.9 * std::numbers::pi / 180.0), 1e-9);
}

/// Values as netCDF4-python reads them.
TEST_F(Seaglider, OfTheBasestationReadsAsAnotherReaderDoesAndLeavesOutWhatItCallsBad) {
  const auto file = sample_folder() / "glider/seaglider_p1800001.nc";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample file is not here";
  const auto report = ingest(file);
  const auto track = track_of(report);
  EXPECT_EQ(track.glider, "sg180");
  EXPECT_EQ(track.points.size(), 3U + 228U);
  EXPECT_EQ(core::unix_seconds(track.points.front().time), 1'782'920'595.0);
  EXPECT_NEAR(track.points.front().place.lat_deg, 47.7331, 1e-9);
  EXPECT_NEAR(track.points.front().place.lon_deg, -122.40511666666667, 1e-9);
  EXPECT_EQ(core::unix_seconds(track.points.back().time), 1'782'922'300.0);
  EXPECT_TRUE(track.currents.empty()) << "depth_avg_curr_qc is 4, bad";
  EXPECT_THAT(words(report), HasSubstr("(depth_avg_curr_qc)"));
  EXPECT_THAT(words(report), HasSubstr("(latlong_qc)"));
  double deepest_m = 0.0;
  for (const auto& point : track.points)
    if (point.depth) deepest_m = std::max(deepest_m, point.depth->value);
  EXPECT_NEAR(deepest_m, 52.09530480162084, 1e-6);
}

TEST_F(Seaglider, OfTheBasestationHasItsDepthAveragedCurrentInItsUnit) {
  {
    NetcdfWriter writer{path("p0010002.nc")};
    writer.attribute("glider", "1");
    writer.attribute("mission", "3");
    writer.attribute("dive_number", "2");
    writer.dimension("gps_info", 3);
    writer.dimension("one", 1);
    const auto variable = [&](const std::string& name, const std::string& dimension,
                              const std::vector<double>& values, const std::string& unit) {
      writer.variable({.name = name,
                       .dimensions = {dimension},
                       .values = values,
                       .texts = {{"units", unit}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    };
    variable("log_gps_time", "gps_info", {1.7e9, 1.7e9 + 100, 1.7e9 + 3700},
             "seconds since 1970-1-1 00:00:00");
    variable("log_gps_lat", "gps_info", {60.0, 60.0, 60.01}, "degrees_north");
    variable("log_gps_lon", "gps_info", {5.0, 5.0, 5.02}, "degrees_east");
    variable("depth_avg_curr_east", "one", {12.0}, "cm/s");
    variable("depth_avg_curr_north", "one", {-0.2}, "m/s");
  }
  const auto track = track_of(ingest(path("p0010002.nc")));
  EXPECT_EQ(track.glider, "sg1");
  ASSERT_EQ(track.currents.size(), 1U);
  EXPECT_NEAR(track.currents[0].current.east.value, 0.12, 1e-9);
  EXPECT_NEAR(track.currents[0].current.north.value, -0.2, 1e-9);
  EXPECT_EQ(core::unix_seconds(track.currents[0].time), 1.7e9 + 1900.0);
}

}  // namespace
}  // namespace floeplan::ingest::seaglider_test
