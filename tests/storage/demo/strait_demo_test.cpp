#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/storage/demo/demo_files.hpp"
#include "tests/support/property.hpp"

namespace floeplan::demo::strait_demo_test {
namespace {

constexpr double glider_m_s = 0.35;

class StraitDemo : public testing::Test {
 protected:
  void SetUp() override {
    const auto files = demo_files(Scenario::strait, 1, "strait");
    east_ = read_component(files[1], "uo");
    north_ = read_component(files[1], "vo");
    middle_row_ = east_.lat_deg.size() / 2;
  }

  [[nodiscard]] std::size_t column_at(double lon_deg) const {
    const auto nearest = std::ranges::min_element(
        east_.lon_deg, {}, [&](double node_deg) { return std::abs(node_deg - lon_deg); });
    return static_cast<std::size_t>(nearest - east_.lon_deg.begin());
  }

  /// Towards the east across the meridian, at the surface: m/s times rows.
  [[nodiscard]] double transport(std::size_t hour, std::size_t column) const {
    double sum = 0.0;
    for (std::size_t row = 0; row < east_.lat_deg.size(); ++row) {
      const double through = east_.at(hour, 0, row, column);
      if (std::isfinite(through)) sum += through;
    }
    return sum;
  }

  Component east_;
  Component north_;
  std::size_t middle_row_{};
};

TEST_F(StraitDemo, RunsInTheNarrowsAtOneAndAHalfTimesTheSpeedOfAGliderAndSlowlyInTheBasins) {
  double narrows_m_s = 0.0;
  double basins_m_s = 0.0;
  for (std::size_t hour = 0; hour < 25; ++hour) {
    for (std::size_t row = 0; row < east_.lat_deg.size(); ++row) {
      for (std::size_t column = 0; column < east_.lon_deg.size(); ++column) {
        const double speed_m_s = std::hypot(east_.at(hour, 0, row, column), north_.at(hour, 0, row, column));
        if (!std::isfinite(speed_m_s)) continue;
        const bool in_narrows = std::abs(east_.lon_deg[column] + 58.5) < 0.06;
        const bool in_basin = std::abs(east_.lon_deg[column] + 58.5) > 0.35;
        if (in_narrows) narrows_m_s = std::max(narrows_m_s, speed_m_s);
        if (in_basin) basins_m_s = std::max(basins_m_s, speed_m_s);
      }
    }
  }

  EXPECT_GT(narrows_m_s, 1.3 * glider_m_s);
  EXPECT_LT(narrows_m_s, 1.75 * glider_m_s);
  EXPECT_LT(basins_m_s, 0.6 * glider_m_s);
}

TEST_F(StraitDemo, ClosesTheNarrowsFromShoreToShoreAgainstTheTide) {
  const std::size_t column = column_at(-58.5);
  double weakest_m_s = -1.0;
  std::size_t wet = 0;
  for (std::size_t row = 0; row < east_.lat_deg.size(); ++row) {
    const double east_m_s = east_.at(8, 0, row, column);
    if (!std::isfinite(east_m_s)) continue;
    weakest_m_s = std::max(weakest_m_s, east_m_s);
    ++wet;
  }

  EXPECT_GE(wet, 7U);
  EXPECT_LT(weakest_m_s, -glider_m_s);
}

TEST_F(StraitDemo, TurnsEverySixHoursAndIsStrongestTwoHoursAfterTheStart) {
  const std::size_t column = column_at(-58.5);
  std::vector<double> turns;
  for (std::size_t hour = 1; hour < east_.times_s.size(); ++hour) {
    const double before = east_.at(hour - 1, 0, middle_row_, column);
    const double after = east_.at(hour, 0, middle_row_, column);
    if ((before < 0.0) != (after < 0.0))
      turns.push_back(static_cast<double>(hour) - after / (after - before));
  }

  ASSERT_GE(turns.size(), 20U);
  EXPECT_NEAR((turns.back() - turns.front()) / static_cast<double>(turns.size() - 1), 6.2, 0.1);
  for (const std::size_t hour : {0U, 1U, 3U, 4U})
    EXPECT_GT(east_.at(2, 0, middle_row_, column), east_.at(hour, 0, middle_row_, column));
}

TEST_F(StraitDemo, CarriesTheSameWaterThroughNarrowsAndBasins) {
  // Where the bed is even, speed times width; it is uneven by a fifth.
  const double narrows = transport(2, column_at(-58.5));
  for (const double lon_deg : {-58.9, -58.7, -58.3, -58.1})
    EXPECT_NEAR(transport(2, column_at(lon_deg)) / narrows, 1.0, 0.3) << lon_deg;
}

TEST(StraitDemoStart, MovesTheSameTideToOtherTimes) {
  const auto files = demo_files(Scenario::strait, 1, "strait");
  const Component first = read_component(files[1], "uo");
  support::for_each_seed(2, [&](std::mt19937_64& rng) {
    const double later_s = 3600.0 * static_cast<double>(rng() % 10'000);
    const auto moved = write_demo(files[0].parent_path().parent_path() / "strait moved", Scenario::strait, 1,
                                  first_hour + core::Seconds{later_s});
    const Component second = read_component(moved[1], "uo");

    ASSERT_EQ(second.times_s.size(), first.times_s.size());
    for (std::size_t i = 0; i < first.times_s.size(); ++i)
      ASSERT_EQ(second.times_s[i], first.times_s[i] + later_s);
    for (std::size_t i = 0; i < first.m_s.size(); ++i)
      ASSERT_TRUE(second.m_s[i] == first.m_s[i] || (std::isnan(second.m_s[i]) && std::isnan(first.m_s[i])));
    EXPECT_EQ(bytes_of(moved[0]), bytes_of(files[0]));
    EXPECT_EQ(bytes_of(moved[2]), bytes_of(files[2]));
  });
}

TEST(StraitDemoMarks, SayInEveryFileThatTheyAreSyntheticAndNotForNavigation) {
  for (const Scenario scenario : {Scenario::strait, Scenario::pack_ice}) {
    const auto files = demo_files(scenario, 1, scenario == Scenario::strait ? "strait" : "pack-ice");
    for (const std::filesystem::path& file : files) {
      EXPECT_NE(file.filename().string().find("synthetic"), std::string::npos);
      EXPECT_NE(bytes_of(file).find("ynthetic, not for navigation"), std::string::npos) << file;
    }
    EXPECT_NE(bytes_of(files[0].parent_path() / "README.txt").find("NOT FOR NAVIGATION"), std::string::npos);
  }
}

}  // namespace
}  // namespace floeplan::demo::strait_demo_test
