#include "engine/planning/plane/plane_polygon.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/property.hpp"

namespace floeplan::planning::plane::plane_polygon_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};

/// A star with a hole in its middle, about 20 km across.
geo::Polygon random_star(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> reach{0.05, 0.12};
  const auto ring = [&](double factor) {
    geo::Ring places;
    for (int i = 0; i < 9; ++i) {
      const double angle = 2.0 * 3.141592653589793 * i / 9.0;
      const double r = factor * reach(rng);
      places.push_back({-53.0 + 2.5 * r * std::cos(angle), 69.0 + r * std::sin(angle)});
    }
    return places;
  };
  return {.outer = ring(1.0), .holes = {ring(0.3)}};
}

geo::PlanePoint random_point(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> coordinate{-15'000.0, 15'000.0};
  return {coordinate(rng), coordinate(rng)};
}

geo::PlanePoint between(geo::PlanePoint a, geo::PlanePoint b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
}

TEST(PlanePolygon, ContainsWhatThePolygonOnTheGlobeContains) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const geo::Polygon star = random_star(rng);
    const PlanePolygon plane{star, projection};
    int differing = 0;
    for (int i = 0; i < 200; ++i) {
      const geo::PlanePoint point = random_point(rng);
      if (plane.contains(point) != geo::contains(star, projection.to_lon_lat(point))) ++differing;
    }
    EXPECT_LE(differing, 1);  // the edges' bend in the plane is metres on a polygon of 20 km
  });
}

TEST(PlanePolygon, IsMetByALineThatAnyOfItsPointsLieIn) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const PlanePolygon plane{random_star(rng), projection};
    const geo::PlanePoint a = random_point(rng);
    const geo::PlanePoint b = random_point(rng);
    bool any_inside = false;
    bool all_inside = true;
    for (int i = 0; i <= 2000; ++i) {
      const bool inside = plane.contains(between(a, b, i / 2000.0));
      any_inside = any_inside || inside;
      all_inside = all_inside && inside;
    }
    EXPECT_TRUE(!any_inside || plane.meets(a, b));
    EXPECT_TRUE(all_inside || !covered({&plane}, a, b));
    EXPECT_EQ(plane.meets(a, b), plane.meets(b, a));
  });
}

TEST(PlanePolygon, CoversALineTogetherWithItsNeighbour) {
  const PlanePolygon west{
      {.outer = {{-53.2, 68.9}, {-53.0, 68.9}, {-53.0, 69.1}, {-53.2, 69.1}}, .holes = {}}, projection};
  const PlanePolygon east{
      {.outer = {{-53.01, 68.9}, {-52.8, 68.9}, {-52.8, 69.1}, {-53.01, 69.1}}, .holes = {}}, projection};
  const geo::PlanePoint a{-6000.0, 0.0};
  const geo::PlanePoint b{6000.0, 0.0};

  EXPECT_FALSE(covered({&west}, a, b));
  EXPECT_TRUE(covered({&west, &east}, a, b));
}

TEST(PlanePolygon, CoversALineAcrossTheSeamWithANeighbourThatItTouches) {
  const auto north_of = [](double south) {
    return PlanePolygon{
        {.outer = {{-53.2, south}, {-52.8, south}, {-52.8, 69.1}, {-53.2, 69.1}}, .holes = {}}, projection};
  };
  const PlanePolygon south{
      {.outer = {{-53.2, 68.9}, {-52.8, 68.9}, {-52.8, 69.0}, {-53.2, 69.0}}, .holes = {}}, projection};
  const geo::PlanePoint a{0.0, -6000.0};
  const geo::PlanePoint b{0.0, 6000.0};

  for (const double apart_m : {0.0, 1e-6, 1.0}) {
    const PlanePolygon north = north_of(69.0 + apart_m / 111'500.0);
    EXPECT_TRUE(covered({&south, &north}, a, b)) << apart_m << " m";
  }
  const PlanePolygon further_north = north_of(69.0 + 4.0 / 111'500.0);
  EXPECT_FALSE(covered({&south, &further_north}, a, b)) << "past a gap";
  EXPECT_FALSE(covered({&south, &further_north}, a, {0.0, 1.0})) << "into the gap";
}

TEST(PlanePolygon, HoldsAPointOfALineWithoutLength) {
  const PlanePolygon square{
      {.outer = {{-53.1, 68.9}, {-52.9, 68.9}, {-52.9, 69.1}, {-53.1, 69.1}}, .holes = {}}, projection};

  EXPECT_TRUE(square.meets({0.0, 0.0}, {0.0, 0.0}));
  EXPECT_TRUE(covered({&square}, {0.0, 0.0}, {0.0, 0.0}));
  EXPECT_FALSE(square.meets({9000.0, 0.0}, {9000.0, 0.0}));
}

}  // namespace
}  // namespace floeplan::planning::plane::plane_polygon_test
