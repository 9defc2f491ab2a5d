#include "engine/ocean/currents/nearest_water.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::ocean {
namespace {

/// Water only in the half of the grid south-west of a diagonal, as a bent grid fills only a part of its box.
bool is_in_the_model(geo::LonLat place) {
  return (place.lon_deg + 56.0) / 6.0 + (place.lat_deg - 67.5) / 3.0 < 1.0;
}

std::shared_ptr<const CurrentGrid> bent() {
  return support::currents_from(
      [](geo::LonLat place, double) {
        return is_in_the_model(place) ? geo::VelocityEn{{0.1}, {0.0}} : geo::VelocityEn{{NAN}, {NAN}};
      },
      2);
}

TEST(NearestWater, IsTheNearestOfAllNodesWithWater) {
  const auto currents = bent();
  const HorizontalGrid grid = support::sea_grid();

  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    std::uniform_real_distribution<double> lon{-57.0, -49.0};
    std::uniform_real_distribution<double> lat{67.0, 71.0};
    const geo::LonLat place{lon(rng), lat(rng)};
    const auto nearest = nearest_water(*currents, place);
    ASSERT_TRUE(nearest.has_value());
    EXPECT_TRUE(is_in_the_model(*nearest));
    const double away = geo::geodesic_between(*nearest, place).length.value;
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy)
      for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
        if (!is_in_the_model(grid.place(ix, iy))) continue;
        EXPECT_LT(away, 1.005 * geo::geodesic_between(grid.place(ix, iy), place).length.value + 1.0);
      }
  });
}

TEST(NearestWater, IsNowhereWithoutWater) {
  const auto land =
      support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{NAN}, {NAN}}; }, 1);
  EXPECT_FALSE(nearest_water(*land, {-53.0, 69.0}).has_value());
  EXPECT_FALSE(has_water_around(*land, {-53.0, 69.0}));
}

TEST(HasWaterAround, ReachesOneNodeBeyondTheWaterAndNotOutOfTheGrid) {
  const auto currents = bent();
  EXPECT_TRUE(has_water_around(*currents, {-55.0, 68.0}));
  EXPECT_TRUE(has_water_around(*currents, {-53.0, 69.01})) << "beside the water";
  EXPECT_FALSE(has_water_around(*currents, {-51.0, 70.0})) << "in the box, but outside the model";
  EXPECT_FALSE(has_water_around(*currents, {-57.0, 68.0}));
}

}  // namespace
}  // namespace floeplan::ocean
