#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::glider_samples_test {
namespace {

/// The values that independent readers find in a real file: ncdump 4.9 of the NetCDF ones, awk of the logs.
/// Packed degrees are worked out by hand.
struct Expected {
  const char* file;
  const char* glider;
  std::size_t points;
  double start_s;
  double end_s;
  geo::LonLat first;
  geo::LonLat last;
  double deepest_m;
  std::size_t currents;
};

void PrintTo(const Expected& sample, std::ostream* out) { *out << sample.file; }

constexpr double epoch_1990_s = 631'152'000.0;

class GliderSample : public StoreFixture, public testing::WithParamInterface<Expected> {};

TEST_P(GliderSample, GivesTheTrackThatAnotherReaderFinds) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const Expected& expected = GetParam();

  const auto report = ingest(sample_folder() / expected.file);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::glider_tracks);
  const auto found = repository::GliderTrackRepository{db_}.list({}, 0, 2);
  ASSERT_EQ(found.tracks.size(), 1U);
  const auto track = repository::GliderTrackRepository{db_}.find(found.tracks.front().row)->track;
  EXPECT_EQ(track.glider, expected.glider);
  EXPECT_EQ(track.points.size(), expected.points) << words(report);
  EXPECT_NEAR(core::unix_seconds(track.points.front().time), expected.start_s, 1e-3);
  EXPECT_NEAR(core::unix_seconds(track.points.back().time), expected.end_s, 1e-3);
  EXPECT_NEAR(track.points.front().place.lon_deg, expected.first.lon_deg, 1e-9);
  EXPECT_NEAR(track.points.front().place.lat_deg, expected.first.lat_deg, 1e-9);
  EXPECT_NEAR(track.points.back().place.lon_deg, expected.last.lon_deg, 1e-9);
  EXPECT_NEAR(track.points.back().place.lat_deg, expected.last.lat_deg, 1e-9);
  EXPECT_NEAR(found.tracks.front().deepest.value_or(core::Metres{}).value, expected.deepest_m, 1e-4);
  EXPECT_EQ(track.currents.size(), expected.currents);
}

INSTANTIATE_TEST_SUITE_P(
    All, GliderSample,
    testing::Values(Expected{"glider/gutils_profile.nc",
                             "bass-20160909T1733",
                             107,  // of 111 rows four repeat the one before
                             epoch_1990_s + 842355077.0,
                             epoch_1990_s + 842355395.0,
                             {-80.252727067217975, 28.472706287001696},
                             {-80.25210327205258, 28.473168688401188},
                             29.678097653687,
                             0},
                    Expected{"glider/gutils_erddap_2.nc",
                             "bass-20171031T0000",
                             411,
                             epoch_1990_s + 878659762.16537,
                             epoch_1990_s + 878661161.57367,
                             {-80.168031610104464, 29.046181995736518},
                             {-80.166184369430823, 29.055269829354081},
                             68.315684112583,
                             0},
                    Expected{"glider/bios_jack_1.nc",
                             "bios_jack-20190619T1424",
                             93,
                             1560988151.93063,
                             1560991184.8822,
                             {-64.574430459533218, 32.239224221100898},
                             {-64.572702966654006, 32.23332294267842},
                             504.53575989982232,
                             0},
                    Expected{"glider/slocum_comet-2019-222-02-154_nav.csv",
                             "slocum_comet-2019-222-02-154_nav",
                             2228,  // 2196 with a position, 32 with a depth between two of them
                             1566395646.217102,
                             1566405768.353241,
                             {7.0 + 24.3016 / 60.0, 54.0 + 18.9931 / 60.0},
                             {7.0 + 21.5827 / 60.0, 54.0 + 19.6355 / 60.0},
                             42.5544,
                             1}));

class SlocumSample : public StoreFixture {
 protected:
  ocean::DepthAveragedCurrent current_of(const std::string& file) {
    const auto report = ingest(sample_folder() / file);
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto found = repository::GliderTrackRepository{db_}.list({}, 0, 2);
    EXPECT_EQ(found.tracks.at(0).track.currents.size(), 1U);
    return found.tracks.at(0).track.currents.at(0);
  }
};

TEST_F(SlocumSample, OfCometHasTheCurrentOfItsDiveNotTheOneThatItDivedWith) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";

  const auto current = current_of("glider/slocum_comet-2019-222-02-154_nav.csv");

  // Logged -0.110802, 0.162143; the variation of 1.3 degrees east and the convergence of -1.31 undo each other.
  EXPECT_NEAR(current.current.east.value, -0.110836, 2e-5);
  EXPECT_NEAR(current.current.north.value, 0.162120, 2e-5);
  EXPECT_NEAR(core::unix_seconds(current.time), 0.5 * (1566395802.487976 + 1566405587.655487), 1e-3);
}

TEST_F(SlocumSample, OfCometIsTurnedByTheAxesThatItsFullLogStates) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";

  const auto current = current_of("glider/comet-2019-222-02-154.dbd");

  // Its x_utm_to_lmc_01 is the sine of 1.1 degrees east: y bears 0.21 degrees west of north.
  const double logged_deg = core::radians_to_degrees(std::atan2(-0.110802, 0.162143));
  const double turned_deg =
      core::radians_to_degrees(std::atan2(current.current.east.value, current.current.north.value));
  EXPECT_NEAR(turned_deg - logged_deg, -0.19, 0.1);
  EXPECT_NEAR(geo::strength(current.current).value, std::hypot(0.110802, 0.162143), 1e-6);
  const auto track = repository::GliderTrackRepository{db_}.list({}, 0, 2).tracks.at(0).track;
  ASSERT_TRUE(track.turned_from);
  EXPECT_EQ(track.turned_from->source, ocean::VariationSource::log_axes);
  EXPECT_EQ(track.turned_from->axes.utm_zone(), 32);
  EXPECT_NEAR(core::radians_to_degrees(track.turned_from->axes.variation_west().value), -1.1, 1e-3);
}

TEST_F(SlocumSample, OfAmadeusHasTheCurrentAfterTheDriftAndNoPlaceWhereItWasSwitchedOffLast) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";

  const auto current = current_of("glider/slocum_amadeus-2014-204-05-000_nav.csv");

  // Logged 0.3666, -0.252742; turned by the variation, 0.1 degrees west once the receiver told it, and the convergence.
  EXPECT_NEAR(current.current.east.value, 0.372564, 1e-6);
  EXPECT_NEAR(current.current.north.value, -0.243865, 1e-6);
  EXPECT_NEAR(core::unix_seconds(current.time), 0.5 * (1406221527.8051758 + 1406225095.6976624), 1e-3);
  // Half way between the last fix before the dive, 5415.9874 N 724.6440 E, and the first after it.
  EXPECT_NEAR(current.place.lat_deg, 54.0 + 0.5 * (15.9874 + 15.6075) / 60.0, 1e-6);
  EXPECT_NEAR(current.place.lon_deg, 7.0 + 0.5 * (24.6440 + 26.7121) / 60.0, 1e-6);
  const auto track = repository::GliderTrackRepository{db_}.list({}, 0, 2).tracks.at(0).track;
  EXPECT_NEAR(core::unix_seconds(track.points.front().time), 1406221482.612671, 1e-3);
  EXPECT_NEAR(track.points.front().place.lat_deg, 54.0 + 15.9907 / 60.0, 1e-9);
}

}  // namespace
}  // namespace floeplan::ingest::glider_samples_test
