#include "api/service/threads.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace floeplan::service::threads_test {
namespace {

TEST(Threads, DoEveryPieceOnceHoweverManyThereAre) {
  for (const std::size_t workers : {1U, 2U, 100U}) {
    std::vector<int> done(53);

    Threads{workers}.run(done.size(), [&](std::size_t piece) { ++done[piece]; });

    EXPECT_EQ(done, std::vector<int>(53, 1)) << workers;
  }
}

TEST(Threads, PassOnWhatAPieceThrows) {
  const auto fails = [](std::size_t piece) {
    if (piece == 5) throw std::runtime_error{"no room"};
  };
  EXPECT_THROW(Threads{4}.run(20, fails), std::runtime_error);
}

}  // namespace
}  // namespace floeplan::service::threads_test
