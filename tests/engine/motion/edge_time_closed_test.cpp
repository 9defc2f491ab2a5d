#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/motion/edge_time.hpp"
#include "tests/engine/motion/random_waves.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion::edge_time_closed_test {
namespace {

constexpr PlaneEdge eastward{{0.0, 0.0}, {10'000.0, 0.0}, {10'000.0}};
constexpr PlaneEdge westward{{10'000.0, 0.0}, {0.0, 0.0}, {10'000.0}};
constexpr EdgeAccuracy kilometre_steps{.longest_step = core::Metres{1'000.0}};

/// A current along the edge, strongest in the middle and weak at the ends.
auto jet(double x_m_s, double y_m_s) {
  return [=](geo::PlanePoint p, core::Seconds) -> std::optional<CurrentXy> {
    const double from_middle = (p.x_m - 5'000.0) / 1'500.0;
    const double share = std::exp(-from_middle * from_middle);
    return CurrentXy{share * x_m_s, share * y_m_s};
  };
}

std::optional<CurrentXy> still(bool known) {
  return known ? std::optional{CurrentXy{0.0, 0.0}} : std::nullopt;
}

TEST(EdgeTime, IsClosedWhereTheCurrentBeatsTheGliderInTheMiddleOfTheEdge) {
  const auto head_on = edge_time(eastward, core::Seconds{0.0}, glider, jet(-0.4, 0.0), kilometre_steps);
  const auto across = edge_time(eastward, core::Seconds{0.0}, glider, jet(0.0, 0.4), kilometre_steps);

  ASSERT_FALSE(head_on.has_value());
  EXPECT_EQ(head_on.error(), EdgeClosed::current_too_strong);
  ASSERT_FALSE(across.has_value());
  EXPECT_EQ(across.error(), EdgeClosed::current_too_strong);
}

TEST(EdgeTime, IsOpenTheOtherWayWhereTheCurrentPushes) {
  EXPECT_TRUE(edge_time(westward, core::Seconds{0.0}, glider, jet(-0.4, 0.0), kilometre_steps).has_value());
}

TEST(EdgeTime, IsOpenThroughACurrentThatTheGliderJustBeats) {
  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, jet(-0.33, 0.0), kilometre_steps);

  ASSERT_TRUE(time.has_value());
  EXPECT_GT(time->count(), 10'000.0 / 0.35);
}

TEST(EdgeTime, IsOutsideTheDataWhereTheFieldEndsOnTheWay) {
  const auto ends = [](geo::PlanePoint p, core::Seconds) { return still(p.x_m <= 6'000.0); };

  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, ends, {});

  ASSERT_FALSE(time.has_value());
  EXPECT_EQ(time.error(), EdgeClosed::outside_data);
}

TEST(EdgeTime, IsOutsideTheDataWhereTheyEndBeforeTheArrival) {
  const auto ends = [](geo::PlanePoint, core::Seconds time) { return still(time.count() <= 20'000.0); };

  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, ends, {});

  ASSERT_FALSE(time.has_value());
  EXPECT_EQ(time.error(), EdgeClosed::outside_data);
}

TEST(EdgeTime, NeedsNoDataBeyondTheEndOfTheEdge) {
  const auto ends = [](geo::PlanePoint p, core::Seconds) -> std::optional<CurrentXy> {
    if (p.x_m > 10'000.0) return std::nullopt;
    return CurrentXy{2e-5 * p.x_m, 0.0};
  };

  EXPECT_TRUE(edge_time(eastward, core::Seconds{0.0}, glider, ends, {}).has_value());
}

TEST(EdgeTime, NeedsDataNoLongerThanTheWayTakes) {
  const auto quicker_and_quicker = [](double end_s) {
    return [=](geo::PlanePoint p, core::Seconds time) -> std::optional<CurrentXy> {
      if (time.count() > end_s) return std::nullopt;
      return CurrentXy{2e-5 * p.x_m, 0.0};
    };
  };
  const double arrival_s =
      edge_time(eastward, core::Seconds{0.0}, glider, quicker_and_quicker(INFINITY), {})->count();

  const auto time =
      edge_time(eastward, core::Seconds{0.0}, glider, quicker_and_quicker(arrival_s + 60.0), {});

  ASSERT_TRUE(time.has_value());
  EXPECT_NEAR(time->count(), arrival_s, 1e-4 * arrival_s);
}

TEST(EdgeTime, IsCutShortByTheLatestArrivalOnlyWhenItWouldComeLater) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const core::Seconds depart{support::uniform(rng, 0.0, 1e5)};
    const EdgeAccuracy accuracy = wave_accuracy(1e-4);
    const auto whole = edge_time(edge, depart, glider, waves, accuracy);
    ASSERT_TRUE(whole.has_value());
    const core::Seconds latest = depart + support::uniform(rng, 0.0, 1.5) * *whole;

    const auto limited = edge_time(edge, depart, glider, waves, accuracy, latest);

    if (limited) {
      EXPECT_EQ(*limited, *whole);
    } else {
      EXPECT_EQ(limited.error(), EdgeClosed::too_late);
      EXPECT_GT(depart + *whole, latest);
    }
  });
}

}  // namespace
}  // namespace floeplan::motion::edge_time_closed_test
