#include "engine/motion/edge_time_back.hpp"

#include <gtest/gtest.h>

#include "tests/engine/motion/random_waves.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion::edge_time_back_test {
namespace {

TEST(EdgeTimeBack, LeavesWhenTheVehicleThatArrivesThenHadLeft) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    constexpr double tolerance = 1e-6;
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const core::Seconds depart{support::uniform(rng, -1e5, 1e5)};
    const auto forwards = edge_time(edge, depart, glider, waves, wave_accuracy(tolerance));
    ASSERT_TRUE(forwards.has_value());

    const auto back = edge_time_back(edge, depart + *forwards, glider, waves, wave_accuracy(tolerance));

    ASSERT_TRUE(back.has_value());
    EXPECT_NEAR(back->count(), forwards->count(), 5.0 * tolerance * forwards->count());
  });
}

TEST(EdgeTimeBack, NeverLeavesEarlierToArriveLater) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    constexpr double tolerance = 1e-6;
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const core::Seconds first{support::uniform(rng, 0.0, 1e5)};
    const core::Seconds second = first + core::Seconds{support::uniform(rng, 0.0, 2e4)};

    const auto to_first = edge_time_back(edge, first, glider, waves, wave_accuracy(tolerance));
    const auto to_second = edge_time_back(edge, second, glider, waves, wave_accuracy(tolerance));

    ASSERT_TRUE(to_first && to_second);
    const double allowed_s = 5.0 * tolerance * to_second->count();
    EXPECT_LE((first - *to_first).count(), (second - *to_second).count() + allowed_s);
  });
}

TEST(EdgeTimeBack, IsClosedWhereTheWaterRunsFasterThanTheVehicle) {
  const auto against = [](geo::PlanePoint, core::Seconds time) -> std::optional<CurrentXy> {
    return CurrentXy{time.count() < 0.0 ? -0.5 : 0.0, 0.0};
  };
  const PlaneEdge eastward{{0.0, 0.0}, {3'500.0, 0.0}, {3'500.0}};

  const auto open = edge_time_back(eastward, core::Seconds{10'001.0}, glider, against, {});
  const auto closed = edge_time_back(eastward, core::Seconds{5'000.0}, glider, against, {});

  EXPECT_NEAR(open->count(), 10'000.0, 1e-6);
  EXPECT_EQ(closed.error(), EdgeClosed::current_too_strong);
}

TEST(EdgeTimeBack, SaysTooLateOnceItWouldLeaveBeforeTheEarliestDeparture) {
  std::mt19937_64 rng{1};
  const RandomWaves waves{rng};
  const PlaneEdge edge = random_edge(rng);
  const core::Seconds arrive{5e4};
  const auto time = edge_time_back(edge, arrive, glider, waves, wave_accuracy(1e-4));

  const auto cut = edge_time_back(edge, arrive, glider, waves, wave_accuracy(1e-4), arrive - 0.2 * *time);
  const auto kept = edge_time_back(edge, arrive, glider, waves, wave_accuracy(1e-4), arrive - 1.1 * *time);

  EXPECT_EQ(cut.error(), EdgeClosed::too_late);
  EXPECT_EQ(kept, time);
}

}  // namespace
}  // namespace floeplan::motion::edge_time_back_test
