#include "engine/planning/plane/plane_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>
#include <vector>

namespace floeplan::planning::plane::plane_grid_test {
namespace {

ocean::Axis nodes(double first, double step, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + step * i);
  return ocean::Axis{std::move(values)};
}

constexpr PlaneBox area{{-25'000.0, -25'000.0}, {25'000.0, 25'000.0}};

/// The map of the area is tabulated. Between the two sides of the cut its points would lie half round the Earth.
TEST(PlaneGrid, FindsNoNodeHalfRoundTheEarthWhereAProjectionIsCut) {
  const ocean::HorizontalGrid europe{geo::LambertConformalFrame{}, nodes(-15e6, 1e5, 301),
                                     nodes(5e6, 1e5, 101)};
  const PlaneGrid grid{europe, geo::LocalProjection{{179.97, 70.0}}, area, std::stop_token{}};

  for (double x = -25'000.0; x <= 25'000.0; x += 500.0)
    for (double y = -25'000.0; y <= 25'000.0; y += 5'000.0)
      EXPECT_FALSE(grid.corner({x, y}).has_value()) << x << " " << y;
}

TEST(PlaneGrid, FindsThePlaceAmongTheNodesOfAnyProjection) {
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const geo::LonLat place{-53.1, 69.05};
  for (const geo::GridFrame& frame :
       {geo::GridFrame{geo::LambertConformalFrame{
            .lat_1_deg = 60.0, .lat_2_deg = 75.0, .lat_0_deg = 69.0, .lon_0_deg = -53.0}},
        geo::GridFrame{
            geo::AlbersFrame{.lat_1_deg = 60.0, .lat_2_deg = 75.0, .lat_0_deg = 69.0, .lon_0_deg = -53.0}},
        geo::GridFrame{geo::AzimuthalEqualAreaFrame{.lat_0_deg = 69.0, .lon_0_deg = -53.0}}}) {
    const ocean::HorizontalGrid data{frame, nodes(-60'000.0, 1000.0, 121), nodes(-60'000.0, 1000.0, 121)};
    const PlaneGrid grid{data, projection, area, std::stop_token{}};

    const auto found = grid.place_among_nodes(projection.to_plane(place));

    const auto exact = data.locate(place);
    ASSERT_TRUE(found && exact);
    const double column = static_cast<double>(exact->x.lower) + exact->x.fraction;
    EXPECT_NEAR(found->x + static_cast<double>(grid.column(0)), column, 1e-3);
  }
}

}  // namespace
}  // namespace floeplan::planning::plane::plane_grid_test
