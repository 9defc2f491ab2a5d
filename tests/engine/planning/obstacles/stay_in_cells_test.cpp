#include "engine/planning/obstacles/stay_in_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/planning/plane/plane_polygon.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::obstacles::stay_in_cells_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
/// The middle of a cell lies in the middle of the projection, where the areas below meet.
const plane::PlaneRaster raster{{{-10'100.0, -10'100.0}, {10'100.0, 10'100.0}}, core::Metres{200.0}};

geo::Polygon box(double west, double south, double east, double north) {
  return {.outer = {{west, south}, {east, south}, {east, north}, {west, north}}, .holes = {}};
}

bool is_held(const std::vector<geo::Polygon>& areas, geo::PlanePoint point) {
  return cells_to_stay_in(areas, raster, projection, {})[raster.index(point).value()];
}

std::ptrdiff_t count_held(const std::vector<geo::Polygon>& areas) {
  return std::ranges::count(cells_to_stay_in(areas, raster, projection, {}), true);
}

geo::PlanePoint random_place_in(const plane::PlaneBox& box, std::mt19937_64& rng) {
  return {support::uniform(rng, box.low.x_m, box.high.x_m), support::uniform(rng, box.low.y_m, box.high.y_m)};
}

constexpr double degree_m = 111'500.0;  // of latitude here

TEST(StayInCells, HoldTheSeamOfAreasThatShareAnEdge) {
  const geo::Polygon west = box(-53.4, 68.8, -53.0, 69.2);
  const geo::Polygon east = box(-53.0, 68.8, -52.6, 69.2);
  const geo::Polygon south = box(-53.4, 68.8, -52.6, 69.0);
  const geo::Polygon north = box(-53.4, 69.0, -52.6, 69.2);

  EXPECT_EQ(count_held({west, east}), static_cast<std::ptrdiff_t>(raster.size()));
  EXPECT_EQ(count_held({south, north}), static_cast<std::ptrdiff_t>(raster.size()));
  EXPECT_EQ(count_held({north, south, west}), static_cast<std::ptrdiff_t>(raster.size()));
}

TEST(StayInCells, HoldTheSeamWhereOneAreaHasMoreCornersOnIt) {
  const geo::Polygon west = box(-53.4, 68.8, -53.0, 69.2);
  geo::Polygon east{.outer = {{-52.6, 69.2}}, .holes = {}};
  for (int i = 0; i <= 370; ++i) east.outer.push_back({-53.0, 69.2 - 0.4 * i / 370.0});
  east.outer.push_back({-52.6, 68.8});

  EXPECT_EQ(count_held({west, east}), static_cast<std::ptrdiff_t>(raster.size()));
}

TEST(StayInCells, LeaveAGapOfSomeMetresClosed) {
  const geo::Polygon south = box(-53.4, 68.8, -52.6, 69.0);
  const auto north_after = [](double gap_m) { return box(-53.4, 69.0 + gap_m / degree_m, -52.6, 69.2); };

  for (const double gap_m : {4.0, 10.0, 100.0, 500.0}) {
    const std::vector<bool> held = cells_to_stay_in({south, north_after(gap_m)}, raster, projection, {});
    for (double x_m = -9'900.0; x_m < 10'000.0; x_m += 200.0) {
      bool all_open = true;
      raster.for_each_cell({x_m, -5'000.0}, {x_m, 5'000.0}, [&](std::int64_t ix, std::int64_t iy) {
        all_open = all_open && held[raster.index(ix, iy)];
        return true;
      });
      EXPECT_FALSE(all_open) << "a gap of " << gap_m << " m at " << x_m;
    }
  }
  EXPECT_TRUE(is_held({south, north_after(0.3)}, {0.0, 0.0})) << "which is within the error of any position";
}

TEST(StayInCells, LetNoWayAcrossAGapWhateverItsDirection) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const double angle = support::uniform(rng, 0.0, std::numbers::pi);
    const geo::PlanePoint middle = random_place_in({{-2'000.0, -2'000.0}, {2'000.0, 2'000.0}}, rng);
    const auto at = [&](double along_m, double across_m) {
      return geo::PlanePoint{middle.x_m + along_m * std::cos(angle) - across_m * std::sin(angle),
                             middle.y_m + along_m * std::sin(angle) + across_m * std::cos(angle)};
    };
    const auto side = [&](double from_m, double to_m) {
      geo::Polygon area;
      for (const auto& [along_m, across_m] :
           {std::pair{-20'000.0, from_m}, {20'000.0, from_m}, {20'000.0, to_m}, {-20'000.0, to_m}})
        area.outer.push_back(projection.to_lon_lat(at(along_m, across_m)));
      return area;
    };
    const double gap_m = support::uniform(rng, 4.0, 300.0);

    const std::vector<bool> held =
        cells_to_stay_in({side(0.0, -20'000.0), side(gap_m, 20'000.0)}, raster, projection, {});

    for (int i = 0; i < 200; ++i) {
      const double along_m = support::uniform(rng, -6'000.0, 6'000.0);
      bool all_open = true;
      raster.for_each_cell(at(along_m, -900.0), at(along_m + support::uniform(rng, -900.0, 900.0), 1'300.0),
                           [&](std::int64_t ix, std::int64_t iy) {
                             all_open = all_open && held[raster.index(ix, iy)];
                             return true;
                           });
      EXPECT_FALSE(all_open) << "a gap of " << gap_m << " m at " << along_m;
    }
  });
}

TEST(StayInCells, HoldNothingThatTouchesInACornerOnly) {
  const geo::Polygon south_west = box(-53.4, 68.8, -53.0, 69.0);
  const geo::Polygon north_east = box(-53.0, 69.0, -52.6, 69.2);

  EXPECT_FALSE(is_held({south_west, north_east}, {0.0, 0.0}));
  EXPECT_TRUE(is_held({south_west, north_east}, {5'000.0, 5'000.0}));
}

/// Two halves of a star, cut along a crooked line, and a third area over some of it.
TEST(StayInCells, HoldNoCellOfWhichAnyPartLiesInNoArea) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const auto place = [](double angle, double r) {
      return geo::LonLat{-53.0 + 2.79 * r * std::cos(angle), 69.0 + r * std::sin(angle)};
    };
    geo::Ring cut;
    for (int i = -4; i <= 4; ++i)
      cut.push_back({-53.0 + 0.05 * i, 69.0 + support::uniform(rng, -0.02, 0.02)});
    geo::Polygon upper{.outer = cut, .holes = {}};
    geo::Polygon lower{.outer = {cut.rbegin(), cut.rend()}, .holes = {}};
    for (int i = 1; i < 8; ++i) {
      const double angle = std::numbers::pi * i / 8.0;
      upper.outer.push_back(place(angle, support::uniform(rng, 0.04, 0.09)));
      lower.outer.push_back(place(angle + std::numbers::pi, support::uniform(rng, 0.04, 0.09)));
    }
    const double west = support::uniform(rng, -53.2, -53.0);
    const double south = support::uniform(rng, 68.93, 69.0);
    const std::vector<geo::Polygon> areas{upper, lower, box(west, south, west + 0.15, south + 0.06)};
    std::vector<plane::PlanePolygon> laid_out;
    for (const geo::Polygon& area : areas) laid_out.emplace_back(area, projection);

    const std::vector<bool> held = cells_to_stay_in(areas, raster, projection, {});

    int along_the_cut = 0;
    for (std::size_t cell = 0; cell < held.size(); ++cell) {
      if (!held[cell]) continue;
      const geo::PlanePoint low{
          raster.area().low.x_m + 200.0 * static_cast<double>(static_cast<std::int64_t>(cell) % raster.nx()),
          raster.area().low.y_m + 200.0 * static_cast<double>(static_cast<std::int64_t>(cell) / raster.nx())};
      const plane::PlaneBox box{low, {low.x_m + 200.0, low.y_m + 200.0}};
      int by_one = 0;
      for (const plane::PlanePolygon& polygon : laid_out) {
        bool all = true;
        for (int i = 0; i < 30; ++i) all = all && polygon.contains(random_place_in(box, rng));
        by_one += all ? 1 : 0;
      }
      along_the_cut += by_one == 0 ? 1 : 0;
      for (int i = 0; i < 30; ++i) {
        const geo::PlanePoint point = random_place_in(box, rng);
        EXPECT_TRUE(
            std::ranges::any_of(laid_out, [&](const plane::PlanePolygon& p) { return p.contains(point); }))
            << point.x_m << " " << point.y_m;
      }
    }
    EXPECT_GT(along_the_cut, 0);
  });
}

/// Areas of half a million corners each, a few centimetres apart: too many to compare each with each.
TEST(StayInCells, AreDecidedInBoundedTimeForOutlinesOfVeryManyCorners) {
  geo::Ring cut;
  constexpr int corners = 500'000;
  for (int i = 0; i < corners; ++i)
    cut.push_back({-53.2 + 0.4 * i / (corners - 1.0), 69.0 + (i % 2 == 0 ? 1e-5 : -1e-5)});
  geo::Polygon upper{.outer = cut, .holes = {}};
  upper.outer.insert(upper.outer.end(), {{-52.8, 69.2}, {-53.2, 69.2}});
  geo::Polygon lower{.outer = {cut.rbegin(), cut.rend()}, .holes = {}};
  lower.outer.insert(lower.outer.end(), {{-53.2, 68.8}, {-52.8, 68.8}});

  const auto began = std::chrono::steady_clock::now();
  const std::vector<bool> held = cells_to_stay_in({upper, lower}, raster, projection, {});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;

  EXPECT_LT(took.count(), 30.0) << "of the many times that, which all pairs of lines would take";
  EXPECT_TRUE(held[raster.index({0.0, 5'000.0}).value()]);
}

}  // namespace
}  // namespace floeplan::planning::obstacles::stay_in_cells_test
