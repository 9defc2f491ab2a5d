#include "engine/geo/geodesic.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::geo::geodesic_test {
namespace {

TEST(Geodesic, MeasuresTheMeridianAndTheEquatorOfWgs84) {
  EXPECT_NEAR(geodesic_between({0.0, 0.0}, {0.0, 90.0}).length.value, 10'001'965.729, 1e-3);
  EXPECT_NEAR(geodesic_between({0.0, 0.0}, {1.0, 0.0}).length.value, 111'319.491, 1e-3);
}

TEST(Geodesic, CrossesTheAntimeridianTheShortWay) {
  const GeodesicLine line = geodesic_between({179.5, 0.0}, {-179.5, 0.0});

  EXPECT_NEAR(line.length.value, 111'319.491, 1e-3);
  EXPECT_NEAR(line.course_at_start.degrees(), 90.0, 1e-9);
}

TEST(Geodesic, IsTheSameLengthBackwards) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat a{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.0, 89.0)};
    const LonLat b{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.0, 89.0)};

    EXPECT_NEAR(geodesic_between(a, b).length.value, geodesic_between(b, a).length.value, 1e-6);
  });
}

TEST(Geodesic, EndsWhereItsCourseAndLengthLead) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const LonLat from{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.0, 89.0)};
    const LonLat to{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.0, 89.0)};

    const GeodesicLine line = geodesic_between(from, to);
    const LonLat reached = geodesic_destination(from, line.course_at_start, line.length);

    EXPECT_LT(geodesic_between(reached, to).length.value, 1e-3);
  });
}

}  // namespace
}  // namespace floeplan::geo::geodesic_test
