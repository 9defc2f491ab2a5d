#include "engine/simulation/world/local_bed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "engine/core/random.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/simulation/sensors/sound_rays.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::local_bed_test {
namespace {

constexpr geo::LonLat origin{-52.0, 47.5};

/// Hills of 30 m, data with nodes every 75 m or so in a square of 3 km.
World hilly_world() {
  std::vector<double> lon;
  std::vector<double> lat;
  for (int i = 0; i <= 40; ++i) {
    lon.push_back(origin.lon_deg - 0.02 + 0.001 * i);
    lat.push_back(origin.lat_deg - 0.0135 + 0.000675 * i);
  }
  std::vector<float> depth_m;
  for (int row = 0; row <= 40; ++row) {
    for (int column = 0; column <= 40; ++column)
      depth_m.push_back(static_cast<float>(90.0 + 30.0 * std::sin(0.7 * column) * std::cos(0.5 * row)));
  }
  const geo::LocalProjection projection{origin};
  const auto bathymetry = std::make_shared<const ocean::Bathymetry>(
      ocean::HorizontalGrid{geo::GridFrame{}, ocean::Axis{lon}, ocean::Axis{lat}}, depth_m);
  WorldParts parts{.origin = origin};
  parts.bed = SeaBed{bathymetry, projection, planning::plane::PlaneBox{{-5000.0, -5000.0}, {5000.0, 5000.0}}};
  return World{std::move(parts)};
}

TEST(LocalBed, IsTheBedOfTheWorldWhereverItWasLaidFrom) {
  const World world = hilly_world();
  LocalBed bed{world, core::Metres{200.0}};
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    const Vector from{support::uniform(rng, -900.0, 900.0), support::uniform(rng, -900.0, 900.0), 20.0};
    bed.look_from(from);
    const double east_m = from.east + support::uniform(rng, -140.0, 140.0);
    const double north_m = from.north + support::uniform(rng, -140.0, 140.0);

    const auto depth_m = bed.depth_m(east_m, north_m);

    ASSERT_TRUE(depth_m.has_value());
    EXPECT_NEAR(*depth_m, *world.bed_depth_m(east_m, north_m), 1.0);
    EXPECT_LE(*bed.shallowest_m(), *depth_m);
    EXPECT_LT(bed.steepest(), 1.0);
  });
}

TEST(LocalBed, KnowsNothingBeyondTheData) {
  const World world = hilly_world();
  LocalBed bed{world, core::Metres{200.0}};
  bed.look_from({1500.0, 0.0, 0.0});

  EXPECT_FALSE(bed.depth_m(1600.0, 0.0).has_value());
  EXPECT_TRUE(bed.depth_m(1400.0, 0.0).has_value());
}

/// Law: the result agrees with steps of a tenth of a metre through the bed of the world.
TEST(SoundRays, MeetHillsWhereSmallStepsDo) {
  const World world = hilly_world();
  SoundRays rays{world, core::Metres{200.0}};
  support::for_each_seed(200, [&](std::mt19937_64& rng) {
    const Vector from{support::uniform(rng, -900.0, 900.0), support::uniform(rng, -900.0, 900.0),
                      support::uniform(rng, 5.0, 55.0)};
    const double azimuth = support::uniform(rng, 0.0, 6.28);
    const double dip = support::uniform(rng, -0.2, 1.0);
    const Vector along{std::cos(dip) * std::sin(azimuth), std::cos(dip) * std::cos(azimuth), std::sin(dip)};
    const auto below_bed_m = [&](double range_m) {
      const Vector place = from + range_m * along;
      return place.down - *world.bed_depth_m(place.east, place.north);
    };
    std::optional<double> stepped;
    for (double range_m = 0.0; range_m <= 180.0 && !stepped; range_m += 0.1) {
      if (below_bed_m(range_m) >= 0.0) stepped = range_m;
    }
    if (!stepped || below_bed_m(*stepped + 10.0) < 2.0) return;  // at most touches a crest
    rays.look_from(from, {});

    const auto hit = rays(from, along, 200.0);

    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->scatterer, Scatterer::sea_bed);
    EXPECT_NEAR(hit->range_m, *stepped, 6.0);
  });
}

}  // namespace
}  // namespace floeplan::simulation::local_bed_test
