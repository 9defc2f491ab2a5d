#include "engine/planning/currents/plane_currents.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::currents::plane_currents_test {
namespace {

using support::currents_from;
using support::sea_start_s;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-60'000.0, -60'000.0}, {60'000.0, 60'000.0}};

PlaneCurrents lay_out(const ocean::CurrentGrid& grid, bool steady = false) {
  return {grid, steady, FlownDepths{{}, nullptr}, projection, area, core::from_unix_seconds(sea_start_s)};
}

TEST(PlaneCurrents, AgreeWithTheFieldTheyWereMadeOf) {
  const auto grid = currents_from(
      [](geo::LonLat p, double hour) {
        return geo::VelocityEn{{0.1 * std::sin(3.0 * p.lon_deg + hour)},
                               {0.1 * std::cos(5.0 * p.lat_deg - hour)}};
      },
      24);
  const PlaneCurrents currents = lay_out(*grid);

  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    std::uniform_real_distribution<double> coordinate{-59'000.0, 59'000.0};
    std::uniform_real_distribution<double> seconds{0.0, 86'400.0};
    const geo::PlanePoint point{coordinate(rng), coordinate(rng)};
    const core::Seconds time{seconds(rng)};

    const auto in_plane = currents(point, time);
    const geo::LonLat place = projection.to_lon_lat(point);
    const auto in_field = grid->at(place, core::Metres{0.0}, core::from_unix_seconds(sea_start_s) + time);

    ASSERT_TRUE(in_plane && in_field);
    const double scale = projection.at(place).scale;
    const geo::PlaneVelocity expected = projection.to_plane(*in_field, place);
    EXPECT_NEAR(in_plane->x_m_s, expected.x_m_s / scale, 2e-4);
    EXPECT_NEAR(in_plane->y_m_s, expected.y_m_s / scale, 2e-4);
  });
}

TEST(PlaneCurrents, TurnANorthwardCurrentIntoTheAxesOfThePlane) {
  const auto grid = currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.0}, {0.3}}; }, 1);
  const PlaneCurrents currents = lay_out(*grid);
  const geo::LonLat place{-51.8, 69.2};
  const geo::LonLat north{-51.8, 69.2001};
  const geo::PlanePoint a = projection.to_plane(place);
  const geo::PlanePoint b = projection.to_plane(north);

  const auto c = currents(a, core::Seconds{0.0});

  ASSERT_TRUE(c.has_value());
  const double length = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
  EXPECT_NEAR(c->x_m_s, 0.3 * (b.x_m - a.x_m) / length, 1e-4);
  EXPECT_NEAR(c->y_m_s, 0.3 * (b.y_m - a.y_m) / length, 1e-4);
}

TEST(PlaneCurrents, ReachOneNodeBeyondTheWaterAndNoFurther) {
  const auto grid = currents_from(
      [](geo::LonLat p, double) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return p.lon_deg < -53.01 ? geo::VelocityEn{{0.2}, {0.0}} : geo::VelocityEn{{nan}, {nan}};
      },
      1);
  const PlaneCurrents currents = lay_out(*grid);
  const auto at = [&](double lon) { return projection.to_plane({lon, 69.0}); };

  EXPECT_TRUE(currents(at(-53.15), core::Seconds{0.0}).has_value());
  EXPECT_FALSE(currents.is_extended(at(-53.25)));
  EXPECT_TRUE(currents(at(-53.02), core::Seconds{0.0}).has_value());
  EXPECT_TRUE(currents.is_extended(at(-53.02)));
  EXPECT_FALSE(currents(at(-52.95), core::Seconds{0.0}).has_value());
}

TEST(PlaneCurrents, AreNotKnownBeforeTheDataBeginOrAfterTheyEnd) {
  const auto grid = currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.1}, {0.0}}; }, 3);

  EXPECT_FALSE(lay_out(*grid)({0.0, 0.0}, core::Seconds{-1.0}).has_value());
  EXPECT_TRUE(lay_out(*grid)({0.0, 0.0}, core::Seconds{3.0 * 3600.0}).has_value());
  EXPECT_FALSE(lay_out(*grid)({0.0, 0.0}, core::Seconds{3.0 * 3600.0 + 1.0}).has_value());
  EXPECT_TRUE(lay_out(grid->time_mean(), true)({0.0, 0.0}, core::Seconds{1e9}).has_value());
}

}  // namespace
}  // namespace floeplan::planning::currents::plane_currents_test
