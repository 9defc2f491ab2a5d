#include "api/routes/access/guess_guard.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::guess_guard_test {
namespace {

constexpr core::UtcTime noon{core::Seconds{1.8e9}};
constexpr core::Seconds none{0.0};

GuessGuard::Shown from(const std::string& address) { return {address, "", "digest"}; }

void guess_wrong(GuessGuard& guard, const std::string& address, int times) {
  for (int i = 0; i < times; ++i) guard.note_wrong(from(address), noon);
}

TEST(GuessGuard, LetsAnAddressBeWrongAFewTimes) {
  GuessGuard guard;
  guess_wrong(guard, "a", 9);
  EXPECT_EQ(guard.wait(from("a"), noon), none);
}

TEST(GuessGuard, SlowsDownTheAddressThatGuessesOn) {
  GuessGuard guard;
  guess_wrong(guard, "a", 10);
  EXPECT_EQ(guard.wait(from("a"), noon), GuessGuard::interval);
  EXPECT_EQ(guard.wait(from("b"), noon), none);
  EXPECT_EQ(guard.wait(from("a"), noon + GuessGuard::interval), none);
}

TEST(GuessGuard, ForgivesOneTryAtATime) {
  GuessGuard guard;
  guess_wrong(guard, "a", 10);
  const core::UtcTime later = noon + GuessGuard::interval;
  guard.note_wrong(from("a"), later);
  EXPECT_GT(guard.wait(from("a"), later), none);
}

TEST(GuessGuard, DoesNotLockOutWhoWasRightFromThereBefore) {
  GuessGuard guard;
  guard.note_right({"a", "", "known"}, noon);
  guess_wrong(guard, "a", 100);
  EXPECT_EQ(guard.wait({"a", "", "known"}, noon), none);
  EXPECT_GT(guard.wait({"a", "", "other"}, noon), none);
}

TEST(GuessGuard, SlowsDownGuessesAtOneTokenFromManyAddresses) {
  GuessGuard guard;
  for (int i = 0; i < 10; ++i) guard.note_wrong({std::to_string(i), "ship", "wrong"}, noon);
  EXPECT_GT(guard.wait({"elsewhere", "ship", "digest"}, noon), none);
  EXPECT_EQ(guard.wait({"elsewhere", "office", "digest"}, noon), none);
  guard.note_right({"home", "ship", "digest"}, noon);
  EXPECT_EQ(guard.wait({"home", "ship", "digest"}, noon), none) << "its owner goes on";
}

/// 300 logins within a second from one address, with one token and with many.
TEST(GuessGuard, OpensLoginsNoFasterThanPeopleLogIn) {
  for (const bool one_token : {true, false}) {
    GuessGuard guard;
    int opened = 0;
    for (int i = 0; i < 300; ++i) {
      const std::string key = one_token ? "ship" : std::to_string(i);
      if (guard.wait_to_log_in({"a", key, ""}, noon) == none) ++opened;
    }
    EXPECT_EQ(opened, one_token ? 20 : 60);
    EXPECT_GT(guard.wait_to_log_in({"a", "ship", ""}, noon), none);
    EXPECT_EQ(guard.wait_to_log_in({"a", "ship", ""}, noon + GuessGuard::login_interval), none);
  }
}

TEST(GuessGuard, KeepsAtItWhenTheClockIsSetBack) {
  GuessGuard guard;
  guess_wrong(guard, "a", 100);
  EXPECT_GT(guard.wait(from("a"), noon - core::Seconds{3600.0}), none);
}

TEST(GuessGuard, ForgetsTheOldestOfTooManyAddresses) {
  GuessGuard guard;
  guess_wrong(guard, "first", 10);
  for (std::size_t i = 0; i < 10'000; ++i)
    guard.note_wrong(from(std::to_string(i)), noon + core::Seconds{1.0});
  EXPECT_EQ(guard.wait(from("first"), noon + core::Seconds{1.0}), none);
}

}  // namespace
}  // namespace floeplan::routes::guess_guard_test
