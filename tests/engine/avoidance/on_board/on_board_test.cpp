#include <gtest/gtest.h>

#include <memory>

#include "engine/avoidance/avoidance_system.hpp"
#include "tests/engine/avoidance/on_board/allocations.hpp"
#include "tests/engine/avoidance/on_board/crowded_sea.hpp"

namespace floeplan::avoidance::on_board_test {
namespace {

std::unique_ptr<AvoidanceSystem> system_on_board() {
  AvoidanceSettings settings;
  settings.deepest = core::Metres{60.0};
  return std::make_unique<AvoidanceSystem>(std::vector<geo::PlanePoint>{{2000.0, 0.0}, {5000.0, 500.0}},
                                           CarriedForecast{geo::VelocityEn{}}, settings);
}

TEST(OnBoard, ReactiveLoopTakesNothingFromTheHeap) {
  const auto system = system_on_board();
  support::CrowdedSea sea{SonarPing::most_returns};
  bool reacted = false;

  std::size_t taken = 0;
  for (int second = 0; second < 120; ++second) {
    const Sensed& sensed = sea.at(second);
    const std::size_t before = support::allocations();
    reacted |= system->react(sensed).mode == Mode::reactive;
    taken += support::allocations() - before;
  }

  EXPECT_EQ(taken, 0U);
  EXPECT_TRUE(reacted);
}

TEST(OnBoard, HeapIsCountedWherePathsArePlanned) {
  const auto system = system_on_board();
  support::CrowdedSea sea{200};
  std::size_t taken = 0;
  for (int second = 0; second < 100; ++second) {
    system->react(sea.at(second));
    const std::size_t before = support::allocations();
    if (system->path_wanted()) system->plan_path();
    taken += support::allocations() - before;
  }
  EXPECT_GT(taken, 0U);
}

TEST(OnBoard, MemoryIsThatOfTheObjectAndBounded) {
  // Twenty-four objects of 192 patches, three lists of waiting echoes, and the lists of one step.
  EXPECT_LT(sizeof(AvoidanceSystem), 512U * 1024U);
}

}  // namespace
}  // namespace floeplan::avoidance::on_board_test
