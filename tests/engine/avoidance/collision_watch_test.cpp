#include "engine/avoidance/collision_watch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/avoidance/steering.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::collision_watch_test {
namespace {

Obstacle obstacle(double x, double y, double radius_m, geo::PlaneVelocity drift = {}) {
  return {{x, y}, drift, radius_m, 0.0, false};
}

TEST(CollisionWatch, NamesTheTimeOfFirstContact) {
  const std::array way{TimedPoint{{0.0, 0.0}, 0.0}, TimedPoint{{100.0, 0.0}, 100.0}};
  const std::array obstacles{obstacle(80.0, 0.0, 5.0), obstacle(50.0, 0.0, 5.0)};
  const auto contact = first_contact(way, obstacles, 10.0);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(*contact, 35.0, 1e-9);
}

TEST(CollisionWatch, SeesWhatDriftsIntoTheWay) {
  const std::array way{TimedPoint{{0.0, 0.0}, 0.0}, TimedPoint{{100.0, 0.0}, 100.0}};
  EXPECT_TRUE(first_contact(way, std::array{obstacle(60.0, 60.0, 5.0, {0.0, -1.0})}, 5.0));
  EXPECT_FALSE(first_contact(way, std::array{obstacle(60.0, 60.0, 5.0, {0.0, 1.0})}, 5.0));
}

TEST(CollisionWatch, LetsWhoIsTooNearLeaveButNotComeNearer) {
  const std::array obstacles{obstacle(10.0, 0.0, 5.0)};
  const std::array away{TimedPoint{{0.0, 0.0}, 0.0}, TimedPoint{{-100.0, 0.0}, 100.0}};
  const std::array nearer{TimedPoint{{0.0, 0.0}, 0.0}, TimedPoint{{100.0, 0.0}, 100.0}};
  EXPECT_FALSE(first_contact(away, obstacles, 30.0));
  EXPECT_TRUE(first_contact(nearer, obstacles, 30.0));
}

TEST(CollisionWatch, OverlooksGuesses) {
  const std::array way{TimedPoint{{0.0, 0.0}, 0.0}, TimedPoint{{100.0, 0.0}, 100.0}};
  Obstacle guess = obstacle(50.0, 0.0, 5.0);
  guess.is_guess = true;
  EXPECT_FALSE(first_contact(way, std::array{guess}, 10.0));
}

/// Law: the result agrees with a test in many small steps.
TEST(CollisionWatch, AgreesWithSmallStepsAlongTheWay) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const auto any = [&] { return support::uniform(rng, -100.0, 100.0); };
    const std::array way{TimedPoint{{any(), any()}, 0.0}, TimedPoint{{any(), any()}, 150.0},
                         TimedPoint{{any(), any()}, 400.0}};
    const Obstacle one = obstacle(any(), any(), 20.0, {0.003 * any(), 0.003 * any()});
    const double radius_m = 30.0;
    if (distance_m(way[0].place, one.centre) < radius_m + 1.0) return;

    std::optional<double> stepped;
    for (double t = 0.0; t <= 400.0 && !stepped; t += 0.05) {
      const std::size_t leg = t < 150.0 ? 0 : 1;
      const double share = (t - way[leg].time_s) / (way[leg + 1].time_s - way[leg].time_s);
      const geo::PlanePoint at{way[leg].place.x_m + share * (way[leg + 1].place.x_m - way[leg].place.x_m),
                               way[leg].place.y_m + share * (way[leg + 1].place.y_m - way[leg].place.y_m)};
      const geo::PlanePoint there{one.centre.x_m + t * one.drift.x_m_s, one.centre.y_m + t * one.drift.y_m_s};
      if (distance_m(at, there) <= radius_m) stepped = t;
    }

    const auto contact = first_contact(way, std::array{one}, 10.0);
    if (stepped) {
      ASSERT_TRUE(contact);
      EXPECT_NEAR(*contact, *stepped, 0.06);
    } else if (contact) {  // a touch between two steps
      EXPECT_GE(*contact, 0.0);
      EXPECT_LE(*contact, 400.0);
    }
  });
}

}  // namespace
}  // namespace floeplan::avoidance::collision_watch_test
