#include "engine/geo/local_projection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::local_projection_test {
namespace {

/// Origins in every zone of the choice of projection, also at the antimeridian and near both poles.
LonLat random_origin(std::mt19937_64& rng) {
  return {support::uniform(rng, -180.0, 180.0), support::uniform(rng, -88.0, 88.0)};
}

LonLat random_neighbour(std::mt19937_64& rng, LonLat origin) {
  return geodesic_destination(origin, Bearing::degrees(support::uniform(rng, 0.0, 360.0)),
                              core::Metres{support::uniform(rng, 0.0, 150'000.0)});
}

/// Step in the plane for a metre on the ground.
PlaneVelocity step(const LocalProjection& projection, LonLat place, double course_deg) {
  constexpr core::Metres length{20.0};
  const PlanePoint a =
      projection.to_plane(geodesic_destination(place, Bearing::degrees(course_deg + 180.0), length));
  const PlanePoint b = projection.to_plane(geodesic_destination(place, Bearing::degrees(course_deg), length));
  return {(b.x_m - a.x_m) / (2.0 * length.value), (b.y_m - a.y_m) / (2.0 * length.value)};
}

TEST(LocalProjection, HasItsOriginAtZeroTrueToScaleAndPointingNorth) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat origin = random_origin(rng);
    const LocalProjection projection{origin};

    EXPECT_NEAR(projection.to_plane(origin).x_m, 0.0, 1e-6);
    EXPECT_NEAR(projection.to_plane(origin).y_m, 0.0, 1e-6);
    EXPECT_NEAR(projection.at(origin).scale, 1.0, 1e-9);
    EXPECT_NEAR(projection.at(origin).convergence.value, 0.0, 1e-9);
  });
}

TEST(LocalProjection, ComesBackToThePlaceItStartedFrom) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat origin = random_origin(rng);
    const LocalProjection projection{origin};
    const LonLat place = random_neighbour(rng, origin);

    const LonLat back = projection.to_lon_lat(projection.to_plane(place));

    EXPECT_LT(geodesic_between(place, back).length.value, 1e-6);
  });
}

TEST(LocalProjection, TurnsAndStretchesVelocitiesAsItMovesPlaces) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat origin = random_origin(rng);
    const LocalProjection projection{origin};
    const LonLat place = random_neighbour(rng, origin);
    if (std::abs(place.lat_deg) > 89.5)
      return;  // twenty metres turn too far there for the difference quotient

    const PlaneVelocity north = projection.to_plane({{0.0}, {1.0}}, place);
    const PlaneVelocity east = projection.to_plane({{1.0}, {0.0}}, place);

    EXPECT_NEAR(north.x_m_s, step(projection, place, 0.0).x_m_s, 1e-5);
    EXPECT_NEAR(north.y_m_s, step(projection, place, 0.0).y_m_s, 1e-5);
    EXPECT_NEAR(east.x_m_s, step(projection, place, 90.0).x_m_s, 1e-3);
    EXPECT_NEAR(east.y_m_s, step(projection, place, 90.0).y_m_s, 1e-3);
  });
}

TEST(LocalProjection, PutsTheEastOnTheRightInBothHemispheres) {
  for (const double lat_deg : {75.0, 40.0, 5.0, -5.0, -40.0, -75.0}) {
    const LocalProjection projection{{179.9, lat_deg}};
    EXPECT_GT(projection.to_plane({-179.9, lat_deg}).x_m, 0.0) << lat_deg;
    EXPECT_GT(projection.to_plane({179.9, lat_deg + 0.1}).y_m, 0.0) << lat_deg;
  }
}

TEST(LocalProjection, LetsAnAreaContainThePole) {
  const LocalProjection projection{{-50.0, 89.0}};

  const PlanePoint beyond = projection.to_plane({130.0, 89.0});

  EXPECT_NEAR(beyond.x_m, 0.0, 1e-6);
  EXPECT_NEAR(beyond.y_m, geodesic_between({-50.0, 89.0}, {130.0, 89.0}).length.value, 20.0);
}

/// A step of a tenth of a degree is short all over the window: no seam, and nothing near infinity. Only at the tip of a
/// cone, the pole of its own hemisphere, lengths grow without bound while places stay near each other.
TEST(LocalProjection, ShowsItsWindowWithoutASeam) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat origin = random_origin(rng);
    const LocalProjection projection{origin};
    const GlobeWindow window = projection.window();
    const double half_width_deg = std::min(window.half_width_deg, 180.0);
    for (int i = 0; i < 100; ++i) {
      const LonLat place{
          origin.lon_deg + support::uniform(rng, -half_width_deg, half_width_deg - 0.1),
          support::uniform(rng, std::max(-88.0, window.south_deg), std::min(88.0, window.north_deg))};

      const PlanePoint here = projection.to_plane(place);
      const PlanePoint east = projection.to_plane({place.lon_deg + 0.1, place.lat_deg});
      const PlanePoint north = projection.to_plane({place.lon_deg, place.lat_deg + 0.1});

      EXPECT_LT(distance_m(here, east), 200'000.0) << place.lon_deg << ' ' << place.lat_deg;
      EXPECT_LT(distance_m(here, north), 200'000.0) << place.lon_deg << ' ' << place.lat_deg;
    }
  });
}

}  // namespace
}  // namespace floeplan::geo::local_projection_test
