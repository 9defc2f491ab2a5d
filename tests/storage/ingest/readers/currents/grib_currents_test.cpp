#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/utc_text.hpp"
#include "tests/storage/ingest/support/grib_writer.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::grib_currents_test {
namespace {

using testing::HasSubstr;

class GribCurrents : public StoreFixture {
 protected:
  ocean::CurrentGrid stored(const std::string& octets) {
    report_ = ingest(write_file("currents.grb2", octets));
    return currents_of(report_);
  }

  IngestReport report_;
};

/// Both components of the turning sea, along true east and north or along the grid's axes, as the flag of the message
/// says.
std::string both_components(GribMessage message) {
  std::string octets;
  for (const int number : {2, 3}) {
    message.number = number;
    message.value = [&message, number](double column, double row) {
      const geo::LonLat here = message.place(column, row);
      const geo::VelocityEn water = turning_sea({geo::wrap_longitude(here.lon_deg), here.lat_deg});
      const geo::LonLat ahead = message.place(column + 1e-4, row);
      const double x_axis =
          std::atan2(ahead.lat_deg - here.lat_deg, geo::longitude_difference(here.lon_deg, ahead.lon_deg) *
                                                       std::cos(here.lat_deg * std::numbers::pi / 180.0));
      const double turn = message.along_grid ? x_axis : 0.0;
      return number == 2 ? water.east.value * std::cos(turn) + water.north.value * std::sin(turn)
                         : water.north.value * std::cos(turn) - water.east.value * std::sin(turn);
    };
    octets += message.octets();
  }
  return octets;
}

void expect_turning_sea(const ocean::CurrentGrid& currents, std::size_t least) {
  const auto& samples = currents.samples();
  std::size_t wet = 0;
  for (std::size_t i = 0; i < samples.u.size(); ++i) {
    if (std::isnan(samples.u[i])) continue;
    ++wet;
    const std::size_t nx = samples.grid.x().size();
    const geo::VelocityEn truth = turning_sea(samples.grid.place(i % nx, i / nx));
    ASSERT_NEAR(samples.u[i], truth.east.value, 1e-3);
    ASSERT_NEAR(samples.v[i], truth.north.value, 1e-3);
  }
  EXPECT_GE(wet, least);
}

TEST_F(GribCurrents, OnLatitudeAndLongitudeAreStoredAsTheyAre) {
  for (const int scanning : {0x40, 0x00}) {
    GribMessage message;
    message.scanning = scanning;
    const auto currents = stored(both_components(message));

    expect_turning_sea(currents, 120);
    EXPECT_EQ(currents.samples().grid.size(), 120U);
    EXPECT_EQ(currents.samples().depths_m->front(), 5.0);
    EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "2026-11-20T06:00:00Z");
  }
}

TEST_F(GribCurrents, AlongAPolarGridAreTurnedWhenTheFlagSaysSo) {
  GribMessage message;
  message.plane = GribPlane::north_polar;
  message.along_grid = true;
  expect_turning_sea(stored(both_components(message)), 120);
  EXPECT_THAT(words(report_), HasSubstr("turned to east and north"));
}

TEST_F(GribCurrents, TowardsEastAndNorthOnAPolarGridAreNotTurned) {
  GribMessage message;
  message.plane = GribPlane::north_polar;
  expect_turning_sea(stored(both_components(message)), 120);
}

TEST_F(GribCurrents, AndWindLieWhereTheyAreInEveryScanningMode) {
  support::for_each_seed(96, [&](std::mt19937_64& rng) {
    GribMessage message;
    message.scanning = support::uniform_int(rng, 0, 15) << 4;
    message.states_increments = support::uniform_int(rng, 0, 3) > 0;
    if (support::uniform_int(rng, 0, 1) == 1) message.wind_height_m = 10.0;
    // Anywhere, so that many grids begin at 0 or lie across 0 and across the date line; some go round the Earth.
    const bool round = support::uniform_int(rng, 0, 4) == 0;
    message.step_deg = round ? 15.0 : 0.25 * support::uniform_int(rng, 1, 8);
    message.columns = round ? 24 : support::uniform_int(rng, 2, 30);
    message.rows = round ? 5 : support::uniform_int(rng, 2, 20);
    const int start = support::uniform_int(rng, -4, 8);
    message.first = {start < 0 ? support::uniform_int(rng, 0, 359) : 45.0 * start,
                     static_cast<double>(support::uniform_int(rng, round ? -60 : -80, round ? 20 : 40))};

    const auto currents = stored(both_components(message));

    const auto& grid = currents.samples().grid;
    expect_turning_sea(currents, static_cast<std::size_t>(message.columns * message.rows));
    ASSERT_EQ(grid.x().size(), static_cast<std::size_t>(message.columns));
    EXPECT_NEAR(geo::longitude_difference(grid.x().front(), message.first.lon_deg), 0.0, 1e-6);
    EXPECT_NEAR(grid.y().front(), message.first.lat_deg, 1e-6);
  });
}

TEST_F(GribCurrents, LieWhereTheyAreOnEveryPlaneInEveryScanningMode) {
  for (const GribPlane plane : {GribPlane::turned_pole, GribPlane::mercator, GribPlane::north_polar,
                                GribPlane::south_polar, GribPlane::lambert}) {
    for (int mode = 0; mode < 16; ++mode) {
      const testing::ScopedTrace trace{
          __FILE__, __LINE__,
          "plane " + std::to_string(static_cast<int>(plane)) + " mode " + std::to_string(mode)};
      GribMessage message;
      message.plane = plane;
      message.scanning = mode << 4;
      message.along_grid = mode % 3 != 0;
      message.first.lon_deg = mode % 2 == 0 ? 174.0 : 356.0;
      message.step_deg = 0.5;

      const auto currents = stored(both_components(message));

      expect_turning_sea(currents, 100);
      if (plane == GribPlane::turned_pole) continue;
      EXPECT_FALSE(std::holds_alternative<geo::GeographicFrame>(currents.samples().grid.frame()));
      EXPECT_EQ(currents.samples().grid.size(), static_cast<std::size_t>(message.columns * message.rows));
    }
  }
}

TEST_F(GribCurrents, WhoseNodesContradictTheirScanningModeAreRefused) {
  support::for_each_seed(16, [&](std::mt19937_64& rng) {
    GribMessage message;
    message.scanning = support::uniform_int(rng, 0, 15) << 4;
    message.plane =
        support::uniform_int(rng, 0, 2) == 0 ? GribPlane::mercator : GribPlane::latitude_longitude;
    message.stated_scanning = message.scanning ^ (support::uniform_int(rng, 0, 1) == 0 ? 0x80 : 0x40);
    const std::string octets = both_components(message);
    expect_refused(write_file("contradiction.grb2", octets), "could be mirrored or shifted");
  });
}

TEST_F(GribCurrents, OnRowsThatAreOffsetAreRefused) {
  for (const int offset : {1, 2, 4, 8}) {
    GribMessage message;
    message.stated_scanning = message.scanning | offset;
    expect_refused(write_file("offset.grb2", both_components(message)), "offset by half a step");
  }
}

TEST_F(GribCurrents, OfSeveralTimesAndDepthsAreOneField) {
  std::string octets;
  for (const int forecast_h : {12, 0})
    for (const double depth_m : {10.0, 2.5}) {
      GribMessage message;
      message.forecast_h = forecast_h;
      message.depth_m = depth_m;
      octets += both_components(message);
    }

  const auto currents = stored(octets);

  EXPECT_THAT(currents.samples().depths_m->nodes(), testing::ElementsAre(2.5, 10.0));
  EXPECT_EQ(currents.samples().times_s.size(), 2U);
}

/// Law: means over layers count for the middles of the layers, and the report says so; a layer without
/// thickness is a depth.
TEST_F(GribCurrents, OfLayersStandAtTheirMiddles) {
  support::for_each_seed(8, [&](std::mt19937_64& rng) {
    db_ = repository::open_store_in_memory();
    std::string octets;
    std::vector<double> middles_m;
    double top_m = support::uniform_int(rng, 0, 5);
    bool any_thick = false;
    for (int count = support::uniform_int(rng, 1, 4); count > 0; --count) {
      const double thick_m = support::uniform_int(rng, 0, 3) * 10.0;
      const bool upside_down = support::uniform_int(rng, 0, 1) == 1;
      GribMessage message;
      message.depth_m = upside_down ? top_m + thick_m : top_m;
      message.layer_ends_m = upside_down ? top_m : top_m + thick_m;
      octets += both_components(message);
      middles_m.push_back(top_m + thick_m / 2.0);
      any_thick = any_thick || thick_m > 0.0;
      top_m += thick_m + support::uniform_int(rng, 1, 5);
    }

    const auto currents = stored(octets);

    ASSERT_THAT(currents.samples().depths_m->nodes(), testing::ElementsAreArray(middles_m));
    EXPECT_EQ(words(report_).find("means over layers") != std::string::npos, any_thick);
  });
}

TEST_F(GribCurrents, OfLayersThatOverlapOrReachTheBedAreRefused) {
  GribMessage upper;
  upper.depth_m = 0.0;
  upper.layer_ends_m = 10.0;
  GribMessage both = upper;
  both.layer_ends_m = 30.0;
  expect_refused(write_file("overlap.grb2", both_components(both) + both_components(upper)),
                 "overlap (0 to 10 m and 0 to 30 m)");
  GribMessage within;
  within.depth_m = 5.0;
  expect_refused(write_file("within.grb2", both_components(upper) + both_components(within)),
                 "overlap (0 to 10 m and 5 m)");
  GribMessage column = upper;
  column.second_type = 9;
  expect_refused(write_file("column.grb2", both_components(column)),
                 "from a depth of 0 m down to a surface of type 9");
}

TEST_F(GribCurrents, AreMissingWhereTheWindOfALayerBlowsAlone) {
  GribMessage wind;
  wind.wind_height_m = 10.0;
  wind.layer_ends_m = 100.0;
  expect_refused(write_file("layer.grb2", both_components(wind)),
                 "holds the wind over the layer from 10 to 100 m above the ground, but no currents");
  wind.layer_ends_m = 10.0;  // no layer, but a height said twice
  EXPECT_EQ(stored(both_components(wind)).samples().grid.size(), 120U);
}

TEST_F(GribCurrents, AreNotTheWindOfTheirFile) {
  std::string octets = both_components({});
  for (const double height_m : {100.0, 10.0}) {
    GribMessage wind;
    wind.wind_height_m = height_m;
    octets += both_components(wind);
  }

  const auto reports = ingest_all(write_file("both.grb2", octets));

  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].dataset.value().kind, repository::DatasetKind::currents);
  EXPECT_EQ(reports[1].dataset.value().kind, repository::DatasetKind::wind);
}

TEST_F(GribCurrents, AndWindAlikeAreTurnedFromTheirGrid) {
  GribMessage message;
  message.wind_height_m = 10.0;
  message.plane = GribPlane::north_polar;
  message.along_grid = true;
  const auto wind = stored(both_components(message));

  expect_turning_sea(wind, 120);
  EXPECT_EQ(report_.dataset->kind, repository::DatasetKind::wind);
  EXPECT_FALSE(wind.samples().depths_m);
}

TEST_F(GribCurrents, AreMissingWhereTheWindBlowsHigherUpAlone) {
  GribMessage wind;
  wind.wind_height_m = 100.0;
  expect_refused(write_file("high.grb2", both_components(wind)),
                 "holds the wind at 100 m above the ground, but no currents of the sea");
}

/// Code table 4.10: 0 a mean, 1 a sum, 2 and 3 extremes, 4 a difference, 5 and 6 a root mean square and a deviation.
TEST_F(GribCurrents, AreNeverAStatisticOfAPeriodButItsMean) {
  GribMessage mean;
  mean.statistic = 0;
  expect_turning_sea(stored(both_components(mean)), 100);
  for (const int statistic : {1, 2, 3, 4, 5, 6}) {
    for (const bool wind : {false, true}) {
      GribMessage message;
      message.statistic = statistic;
      if (wind) message.wind_height_m = 10.0;
      expect_refused(write_file("spread.grb2", both_components(message)),
                     "extremes, sums or deviations of the");
      message.first.lon_deg += 20.0;  // beside the mean of the same time, and before it
      GribMessage beside;
      beside.statistic = 0;
      beside.depth_m = 5.0 + statistic + (wind ? 10.0 : 0.0);  // another file
      expect_turning_sea(stored(both_components(message) + both_components(beside)), 100);
    }
  }
}

TEST_F(GribCurrents, OfAMeanStandInTheMiddleOfItsPeriod) {
  GribMessage mean;
  mean.statistic = 0;
  mean.period_begins_h = 0;
  mean.forecast_h = 6;
  (void)stored(both_components(mean));
  EXPECT_EQ(report_.dataset->time_start, core::parse_iso8601("2026-11-20T03:00:00Z"));
}

TEST_F(GribCurrents, WithAGapAreRefused) {
  GribMessage later;
  later.forecast_h = 12;
  later.number = 2;
  later.value = [](double, double) { return 0.1; };
  expect_refused(write_file("gap.grb2", both_components({}) + later.octets()), "lacks a component");
}

TEST_F(GribCurrents, AsSpeedAndDirectionAreRefused) {
  GribMessage message;
  message.number = 1;
  message.value = [](double column, double) { return 0.1 + 0.01 * column; };
  expect_refused(write_file("speed.grb2", message.octets()), "speed and direction");
}

TEST_F(GribCurrents, CutShortAnywhereAreRefused) {
  const std::string whole = both_components({});
  for (int percent = 5; percent < 100; percent += 5)
    expect_refused(
        write_file("cut.grb2", whole.substr(0, whole.size() * static_cast<std::size_t>(percent) / 100)),
        percent == 50 ? "lacks a component" : "cut short");
}

}  // namespace
}  // namespace floeplan::ingest::grib_currents_test
