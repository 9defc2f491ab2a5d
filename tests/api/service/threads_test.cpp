#include "api/service/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace floeplan::service::threads_test {
namespace {

TEST(Threads, DoEveryPieceOnceHoweverManyThereAre) {
  for (const std::size_t workers : {1U, 2U, 7U, 100U}) {
    std::vector<int> done(53);

    Threads{workers}.run(done.size(), [&](std::size_t piece, bool) { ++done[piece]; });

    EXPECT_EQ(done, std::vector<int>(53, 1)) << workers;
  }
}

TEST(Threads, TellEachPieceWhetherItsThreadIsTheCallers) {
  const auto caller = std::this_thread::get_id();
  std::vector<int> right(20);

  Threads{3}.run(right.size(), [&](std::size_t piece, bool is_caller) {
    right[piece] = is_caller == (std::this_thread::get_id() == caller) ? 1 : 0;
  });

  EXPECT_EQ(right, std::vector<int>(20, 1));
}

TEST(Threads, PassOnWhatAPieceThrowsAndBeginNoMore) {
  std::atomic<int> begun{0};
  const auto fails = [&](std::size_t, bool) {
    ++begun;
    throw std::runtime_error{"no room"};
  };

  EXPECT_THROW(Threads{4}.run(1000, fails), std::runtime_error);
  EXPECT_LE(begun, 4);
}

TEST(Threads, HaveNothingToDoForNoPieces) {
  Threads{4}.run(0, [](std::size_t, bool) { FAIL(); });
}

}  // namespace
}  // namespace floeplan::service::threads_test
