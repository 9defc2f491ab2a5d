#include "engine/core/executor.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace floeplan::core::executor_test {
namespace {

using Numbers = std::vector<std::size_t>;

TEST(InOrder, DoesOnePieceAfterTheOther) {
  Numbers begun;

  in_order().run(3, [&](std::size_t piece, bool is_caller) {
    begun.push_back(piece);
    EXPECT_TRUE(is_caller);
  });

  EXPECT_EQ(begun, (Numbers{0, 1, 2}));
}

TEST(InOrder, PassesOnWhatAPieceThrowsAndBeginsNoMore) {
  Numbers begun;
  const auto second_fails = [&](std::size_t piece, bool) {
    begun.push_back(piece);
    if (piece == 1) throw std::runtime_error{"no room"};
  };

  EXPECT_THROW(in_order().run(3, second_fails), std::runtime_error);
  EXPECT_EQ(begun, (Numbers{0, 1}));
}

TEST(CountOfEnded, TellsTheCallerWhatEndedOnAllThreads) {
  Numbers told;
  CountOfEnded count{[&](std::size_t ended) { told.push_back(ended); }};

  count.add(true);
  count.add(false);
  count.add(true);

  EXPECT_EQ(told, (Numbers{1, 3}));
}

}  // namespace
}  // namespace floeplan::core::executor_test
