#include "engine/core/executor.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace floeplan::core::executor_test {
namespace {

using Numbers = std::vector<std::size_t>;

TEST(InOrder, DoesOnePieceAfterTheOtherAndTellsOfEach) {
  Numbers begun;
  Numbers told;

  in_order().run(
      3, [&](std::size_t piece) { begun.push_back(piece); }, [&](std::size_t n) { told.push_back(n); });

  EXPECT_EQ(begun, (Numbers{0, 1, 2}));
  EXPECT_EQ(told, (Numbers{1, 2, 3}));
}

TEST(InOrder, PassesOnWhatAPieceThrowsAndBeginsNoMore) {
  Numbers begun;
  const auto second_fails = [&](std::size_t piece) {
    begun.push_back(piece);
    if (piece == 1) throw std::runtime_error{"no room"};
  };

  EXPECT_THROW(in_order().run(3, second_fails, [](std::size_t) {}), std::runtime_error);
  EXPECT_EQ(begun, (Numbers{0, 1}));
}

}  // namespace
}  // namespace floeplan::core::executor_test
