#include "api/routes/guess_guard.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::guess_guard_test {
namespace {

constexpr core::UtcTime noon{core::Seconds{1.8e9}};
constexpr core::Seconds none{0.0};

void guess_wrong(GuessGuard& guard, const std::string& address, int times) {
  for (int i = 0; i < times; ++i) guard.note_wrong(address, noon);
}

TEST(GuessGuard, LetsAnAddressBeWrongAFewTimes) {
  GuessGuard guard;
  guess_wrong(guard, "a", 9);
  EXPECT_EQ(guard.wait("a", "digest", noon), none);
}

TEST(GuessGuard, SlowsDownTheAddressThatGuessesOn) {
  GuessGuard guard;
  guess_wrong(guard, "a", 10);
  EXPECT_EQ(guard.wait("a", "digest", noon), GuessGuard::interval);
  EXPECT_EQ(guard.wait("b", "digest", noon), none);
  EXPECT_EQ(guard.wait("a", "digest", noon + GuessGuard::interval), none);
}

TEST(GuessGuard, ForgivesOneTryAtATime) {
  GuessGuard guard;
  guess_wrong(guard, "a", 10);
  const core::UtcTime later = noon + GuessGuard::interval;
  guard.note_wrong("a", later);
  EXPECT_GT(guard.wait("a", "digest", later), none);
}

TEST(GuessGuard, DoesNotLockOutWhoWasRightFromThereBefore) {
  GuessGuard guard;
  guard.note_right("a", "known", noon);
  guess_wrong(guard, "a", 100);
  EXPECT_EQ(guard.wait("a", "known", noon), none);
  EXPECT_GT(guard.wait("a", "other", noon), none);
}

TEST(GuessGuard, KeepsAtItWhenTheClockIsSetBack) {
  GuessGuard guard;
  guess_wrong(guard, "a", 100);
  EXPECT_GT(guard.wait("a", "digest", noon - core::Seconds{3600.0}), none);
}

TEST(GuessGuard, ForgetsTheOldestOfTooManyAddresses) {
  GuessGuard guard;
  guess_wrong(guard, "first", 10);
  for (std::size_t i = 0; i < GuessGuard::most_addresses; ++i)
    guard.note_wrong(std::to_string(i), noon + core::Seconds{1.0});
  EXPECT_EQ(guard.wait("first", "digest", noon + core::Seconds{1.0}), none);
}

}  // namespace
}  // namespace floeplan::routes::guess_guard_test
