#include "storage/ingest/readers/coastline/gshhg_bin.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace floeplan::ingest::gshhg_bin_test {
namespace {

constexpr std::uint16_t far = 65535;

ShoreBin bin_with(std::vector<ShoreSegment> segments, int corner_level) {
  return {.south_west = {-54.0, 69.0},
          .size_deg = 1.0,
          .corner_levels = {corner_level, corner_level, corner_level, corner_level},
          .segments = std::move(segments)};
}

/// A place in the bin by its shares of the way east and north.
bool is_land(const std::vector<geo::Polygon>& land, double east, double north) {
  const geo::LonLat place{-54.0 + east, 69.0 + north};
  return std::ranges::any_of(land, [&](const geo::Polygon& piece) { return geo::contains(piece, place); });
}

ShoreSegment closed(int level, std::uint16_t low, std::uint16_t high) {
  return {
      level, BinSide::none, BinSide::none, {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}}};
}

TEST(GshhgBin, WithoutShoreIsAllLandOrAllSeaByItsCorners) {
  EXPECT_TRUE(land_of(bin_with({}, 0)).empty());
  EXPECT_TRUE(land_of(bin_with({}, 2)).empty());

  const auto land = land_of(bin_with({}, 1));

  ASSERT_EQ(land.size(), 1U);
  EXPECT_EQ(land.front().outer.size(), 4U);
  EXPECT_TRUE(is_land(land, 0.5, 0.5));
}

TEST(GshhgBin, HasLandOnTheLeftOfACoastThatCrossesIt) {
  const auto land =
      land_of(bin_with({{1, BinSide::south, BinSide::north, {{30000, 0}, {32000, 20000}, {30000, far}}}}, 0));

  ASSERT_EQ(land.size(), 1U);
  EXPECT_TRUE(is_land(land, 0.1, 0.9));
  EXPECT_TRUE(is_land(land, 0.1, 0.1));
  EXPECT_FALSE(is_land(land, 0.9, 0.9));
  EXPECT_FALSE(is_land(land, 0.9, 0.1));
}

TEST(GshhgBin, ClosesAHeadlandAlongItsSideAndABayRoundAllCorners) {
  const ShoreSegment headland{
      1, BinSide::south, BinSide::south, {{50000, 0}, {50000, 9000}, {10000, 9000}, {10000, 0}}};
  const ShoreSegment bay{
      1, BinSide::south, BinSide::south, {{10000, 0}, {10000, 9000}, {50000, 9000}, {50000, 0}}};

  const auto land = land_of(bin_with({headland}, 0));
  const auto land_around_bay = land_of(bin_with({bay}, 1));

  EXPECT_TRUE(is_land(land, 0.5, 0.1));
  EXPECT_FALSE(is_land(land, 0.5, 0.5));
  EXPECT_FALSE(is_land(land_around_bay, 0.5, 0.1));
  EXPECT_TRUE(is_land(land_around_bay, 0.5, 0.5));
  EXPECT_TRUE(is_land(land_around_bay, 0.05, 0.05));
  EXPECT_TRUE(is_land(land_around_bay, 0.95, 0.05));
}

TEST(GshhgBin, KeepsTheTwoShoresOfAStraitApart) {
  const ShoreSegment western{1, BinSide::south, BinSide::north, {{20000, 0}, {20000, far}}};
  const ShoreSegment eastern{1, BinSide::north, BinSide::south, {{40000, far}, {40000, 0}}};

  const auto land = land_of(bin_with({western, eastern}, 1));

  EXPECT_EQ(land.size(), 2U);
  EXPECT_TRUE(is_land(land, 0.1, 0.5));
  EXPECT_FALSE(is_land(land, 0.45, 0.5));
  EXPECT_TRUE(is_land(land, 0.9, 0.5));
}

TEST(GshhgBin, CutsALakeOutOfTheLandAndKeepsItsIsland) {
  const auto land = land_of(bin_with({closed(2, 10000, 50000), closed(3, 25000, 35000)}, 1));

  EXPECT_TRUE(is_land(land, 0.05, 0.05));
  EXPECT_FALSE(is_land(land, 0.25, 0.25));
  EXPECT_TRUE(is_land(land, 0.45, 0.45));
}

}  // namespace
}  // namespace floeplan::ingest::gshhg_bin_test
