#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>

#include "storage/json/json.hpp"
#include "storage/repository/fields/tide_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/storage/ingest/support/tcd_writer.hpp"

namespace floeplan::ingest::tcd_test {
namespace {

using repository::TideStation;
using testing::HasSubstr;

class Tcd : public StoreFixture {
 protected:
  std::vector<TideStation> stored(const std::filesystem::path& file) {
    report_ = ingest(file);
    if (!report_.dataset) throw std::runtime_error{words(report_)};
    return repository::TideRepository{db_}.stations(report_.dataset->id);
  }
  std::vector<TideStation> stored(const std::vector<TcdSampleStation>& stations) {
    write_tcd(path("tides.tcd"), stations);
    return stored(path("tides.tcd"));
  }

  IngestReport report_;
};

std::complex<double> constant(const TideStation& station, const std::string& name) {
  const auto found = std::ranges::find(station.constants, tide::find_constituent(name),
                                       &tide::HarmonicConstant::constituent);
  if (found == station.constants.end()) throw std::runtime_error{"no " + name};
  return found->value;
}

/// A station off San Francisco: the amplitude and both phases of M2 that NOAA publishes for it.
TcdSampleStation san_francisco() {
  return {.name = "San Francisco",
          .place = {-122.4659, 37.8063},
          .unit = "feet",
          .zone = 0,
          .constants = {{"M2", {1.89, 208.2}}}};
}

TEST_F(Tcd, IsStoredInMetresWithPhasesBehindGreenwich) {
  const auto stations = stored({san_francisco()});

  ASSERT_EQ(stations.size(), 1U);
  EXPECT_EQ(stations[0].name, "San Francisco");
  EXPECT_NEAR(stations[0].place.lon_deg, -122.4659, 1e-5);
  EXPECT_NEAR(stations[0].place.lat_deg, 37.8063, 1e-5);
  EXPECT_EQ(stations[0].quantity, ocean::TideQuantity::elevation);
  EXPECT_LT(std::abs(constant(stations[0], "M2") - tide::harmonic_value(1.89 * 0.3048, 208.2)), 1e-6);
  EXPECT_TRUE(report_.warnings.empty()) << words(report_);
}

TEST_F(Tcd, WhosePhasesCountFromAnotherZoneIsTurnedToGreenwich) {
  TcdSampleStation of_local_time = san_francisco();
  of_local_time.zone = -800;
  of_local_time.constants = {{"M2", {1.89, 336.4}}};  // NOAA's phase_local
  const double rounded_deg = 0.2;                     // both are printed with one digit
  const auto west = stored({of_local_time});
  EXPECT_NEAR(std::arg(constant(west[0], "M2") / tide::harmonic_value(1.0, 208.2)), 0.0, rounded_deg / 57.0);

  TcdSampleStation half_an_hour = san_francisco();
  half_an_hour.zone = 530;
  half_an_hour.constants = {{"S2", {1.0, 200.0}}};  // 30 degrees an hour: 165 degrees in five and a half
  const auto east = stored({half_an_hour});
  EXPECT_LT(std::abs(constant(east[0], "S2") - tide::harmonic_value(0.3048, 35.0)), 1e-5);
}

TEST_F(Tcd, LeavesOutWhatIsNoWaterLevelOfItsOwnAndSaysSo) {
  TcdSampleStation current = san_francisco();
  current.unit = "knots";
  TcdSampleStation nowhere = san_francisco();
  nowhere.place = {0.0, 0.0};
  TcdSampleStation differing = san_francisco();
  differing.differs_from = 0;
  TcdSampleStation of_ios = san_francisco();
  of_ios.constants["SA-IOS"] = {0.5, 100.0};

  const auto stations = stored({of_ios, current, nowhere, differing});

  ASSERT_EQ(stations.size(), 1U);
  EXPECT_EQ(stations[0].constants.size(), 1U);
  EXPECT_EQ(report_.dataset->rows_accepted, 1);
  EXPECT_EQ(report_.dataset->rows_refused, 3);
  EXPECT_THAT(words(report_), HasSubstr("1 of tidal currents, 1 given as differences"));
  EXPECT_THAT(words(report_), HasSubstr("have another speed in this program, were left out: SA-IOS"));
}

TEST_F(Tcd, WithNoStationOfWaterLevelsIsRefused) {
  TcdSampleStation current = san_francisco();
  current.unit = "knots";
  write_tcd(path("currents.tcd"), {current});
  expect_refused(path("currents.tcd"), "no station with a place and harmonic constants");
  write_tcd(path("empty.tcd"), {});
  expect_refused(path("empty.tcd"), "holds no station");
}

TEST_F(Tcd, WithAnAmplitudeThatNoTideHasIsRefused) {
  TcdSampleStation station = san_francisco();
  station.unit = "meters";
  station.constants["S2"] = {25.0, 10.0};
  write_tcd(path("high.tcd"), {station});
  expect_refused(path("high.tcd"), "San Francisco: the amplitude of S2 is 25 m");
}

TEST_F(Tcd, ThatWasCutShortIsRefusedBeforeAnythingOpensIt) {
  write_tcd(path("whole.tcd"), {san_francisco()});
  std::ifstream in{path("whole.tcd"), std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  expect_refused(write_file("cut.tcd", bytes.substr(0, bytes.size() - 10)), "was cut short");
}

/// The same stations as NOAA publishes them: feet to a hundredth there, metres to a thousandth here.
TEST_F(Tcd, OfXtideHoldsTheConstantsThatNoaaPublishes) {
  const auto file = sample_folder() / "tides/harmonics-dwf-20210110-free.tcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample file is not here";
  const auto stations = stored(file);
  EXPECT_EQ(stations.size(), 1105U);
  EXPECT_EQ(report_.dataset->rows_refused, 2626 + 4453);
  int compared = 0;
  for (const auto& [json, name] :
       {std::pair{"noaa_san-francisco-golden-gate.json", "San Francisco, San Francisco Bay, California"},
        std::pair{"noaa_honolulu.json", "Honolulu, Honolulu Harbor, Oahu Island, Hawaii"},
        std::pair{"noaa_anchorage-knik-arm.json", "Anchorage, Knik Arm, Cook Inlet, Alaska"}}) {
    const auto station = std::ranges::find(stations, name, &TideStation::name);
    ASSERT_NE(station, stations.end()) << name;
    std::ifstream in{sample_folder() / "tides" / json};
    const nlohmann::json document = nlohmann::json::parse(in);
    for (const auto& published : document["harmonic_constituents"]) {
      const double amplitude_m = published["amplitude"].get<double>();
      if (amplitude_m < 0.02 || published["name"] == "OO2") continue;  // which XTide calls OQ2-HORN
      const auto value = constant(*station, published["name"].get<std::string>());
      const auto noaa = tide::harmonic_value(amplitude_m, published["phase_UTC"].get<double>());
      EXPECT_LT(std::abs(value - noaa), 0.003 + 0.005 * amplitude_m) << name << " " << published["name"];
      ++compared;
    }
  }
  EXPECT_GT(compared, 70);
}

}  // namespace
}  // namespace floeplan::ingest::tcd_test
