#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::wind_test {
namespace {

using repository::DatasetKind;
using testing::HasSubstr;

class Wind : public StoreFixture {
 protected:
  static CurrentFile wind_file() {
    CurrentFile file;
    file.u_name = "u10";
    file.v_name = "v10";
    file.u_texts = {{"units", "m s-1"}, {"long_name", "10 metre U wind component"}};
    file.v_texts = {{"units", "m s-1"}, {"long_name", "10 metre V wind component"}};
    file.value = [](char component, std::size_t time, std::size_t, std::size_t y, std::size_t x) {
      const double part = component == 'u' ? 1.0 : -1.0;
      return part * (5.0 + static_cast<double>(time)) + static_cast<double>(x) - static_cast<double>(y);
    };
    return file;
  }

  IngestReport stored(const CurrentFile& file) {
    file.write(path("wind.nc"));
    return ingest(path("wind.nc"));
  }
};

TEST_F(Wind, IsStoredAsItBlows) {
  const CurrentFile file = wind_file();
  const auto report = stored(file);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, DatasetKind::wind);
  const ocean::CurrentGrid field = currents_of(report);
  EXPECT_FALSE(field.samples().depths_m);
  const auto wind = field.at({2.0, 51.0}, core::Metres{0.0}, *report.dataset->time_end);
  ASSERT_TRUE(wind);
  EXPECT_NEAR(wind->east.value, file.value('u', 1, 0, 1, 2), 1e-5);
  EXPECT_NEAR(wind->north.value, file.value('v', 1, 0, 1, 2), 1e-5);
}

TEST_F(Wind, IsBroughtToMetresASecond) {
  CurrentFile file = wind_file();
  file.u_texts["units"] = "knots";
  file.v_texts["units"] = "knots";
  const auto report = stored(file);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto wind = currents_of(report).at({0.0, 50.0}, core::Metres{0.0}, *report.dataset->time_start);
  EXPECT_NEAR(wind.value().east.value, 5.0 * 1852.0 / 3600.0, 1e-5);
}

TEST_F(Wind, AsSpeedAndDirectionIsRefusedAsSuch) {
  CurrentFile file = wind_file();
  file.u_name = "wind_speed";
  file.v_name = "wind_dir";
  file.u_texts = {{"units", "m s-1"}, {"standard_name", "wind_speed"}};
  file.v_texts = {{"units", "degree"}, {"standard_name", "wind_from_direction"}};
  file.write(path("wind.nc"));
  expect_refused(path("wind.nc"), "the wind as a speed and a direction");

  file.u_name = "speed";
  file.v_name = "direction";
  file.u_texts = {{"units", "m s-1"}, {"standard_name", "sea_water_speed"}};
  file.v_texts = {{"units", "degree"}, {"standard_name", "sea_water_to_direction"}};
  file.write(path("current.nc"));
  expect_refused(path("current.nc"), "the current as a speed and a direction");
}

TEST_F(Wind, IsNeverFasterThanAnyWind) {
  CurrentFile file = wind_file();
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t) { return 75.0; };
  file.write(path("wind.nc"));
  expect_refused(path("wind.nc"), "stronger than any wind");
}

TEST_F(Wind, OfOneComponentAloneIsRefused) {
  CurrentFile file = wind_file();
  file.with_north = false;
  file.write(path("wind.nc"));
  expect_refused(path("wind.nc"), "only one component of the wind");
}

TEST_F(Wind, IsTakenAtTenMetres) {
  CurrentFile file = wind_file();
  file.u_name = "eastward_wind";
  file.v_name = "northward_wind";
  file.depths = {2.0, 10.0, 50.0};
  file.depth_texts = {{"units", "m"}, {"positive", "up"}, {"standard_name", "height"}};
  file.value = [](char, std::size_t, std::size_t level, std::size_t, std::size_t) {
    return level == 1 ? 7.0 : 20.0;
  };
  const auto report = stored(file);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto wind = currents_of(report).at({1.0, 51.0}, core::Metres{0.0}, *report.dataset->time_start);
  EXPECT_NEAR(wind.value().east.value, 7.0, 1e-6);

  file.depths = {100.0};
  file.write(path("high.nc"));
  expect_refused(path("high.nc"), "not at 10 m");
}

TEST_F(Wind, OnALevelOfTheModelIsRefused) {
  CurrentFile file = wind_file();
  file.u_name = "u";
  file.v_name = "v";
  file.u_texts = {{"units", "m s-1"}, {"standard_name", "eastward_wind"}};
  file.v_texts = {{"units", "m s-1"}, {"standard_name", "northward_wind"}};
  file.depths = {137.0};
  file.depth_texts = {
      {"units", "1"}, {"positive", "down"}, {"standard_name", "atmosphere_hybrid_sigma_pressure_coordinate"}};
  file.write(path("wind.nc"));
  expect_refused(path("wind.nc"), "is given on levels of the model (\"depth\")");
}

TEST_F(Wind, OfRealFilesStandsBesideTheirCurrents) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto reports = ingest_all(sample_folder() / "currents/wrt_reduced_weather.nc");

  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].dataset.value().kind, DatasetKind::currents);
  ASSERT_EQ(reports[1].status, IngestStatus::stored) << words(reports[1]);
  EXPECT_EQ(reports[1].dataset->kind, DatasetKind::wind);
  EXPECT_THAT(reports[1].dataset->variables.front(), HasSubstr("wind_height_above_ground"));
}

}  // namespace
}  // namespace floeplan::ingest::wind_test
