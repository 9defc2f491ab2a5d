#include "storage/sandbox/confinement.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <thread>

#include "storage/sandbox/system_call_filter.hpp"
#include "tests/storage/sandbox/attempts.hpp"
#include "tests/support/loopback_listener.hpp"

namespace floeplan::sandbox::confinement_test {
namespace {

namespace fs = std::filesystem;

class Confinement : public testing::Test {
 protected:
  Confinement()
      : scene_{fs::path{testing::TempDir()} / ("sandbox_" + std::to_string(getpid())), listener_.port()} {
    fs::remove_all(scene_.folder);
    fs::create_directories(scene_.staging());
    std::ofstream{scene_.store()} << "plans";
    std::ofstream{scene_.given()} << "currents";
    fs::permissions(scene_.store(), fs::perms::owner_read | fs::perms::owner_write);
  }
  ~Confinement() override { fs::remove_all(scene_.folder); }

  [[nodiscard]] FileNeeds needs() const { return {.read = {scene_.given()}, .write = scene_.staging()}; }

  [[nodiscard]] std::string content_of(const fs::path& file) const {
    std::ifstream in{file};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  void expect_nothing_happened() const {
    EXPECT_FALSE(listener_.somebody_came());
    EXPECT_EQ(content_of(scene_.store()), "plans");
    EXPECT_EQ(content_of(scene_.given()), "currents");
    EXPECT_EQ(fs::status(scene_.store()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_FALSE(fs::exists(scene_.folder / "new"));
    EXPECT_TRUE(fs::is_empty(scene_.staging()));
  }

  const support::LoopbackListener listener_;
  const Scene scene_;
};

TEST_F(Confinement, IsEnoughOnThisMachine) {
  const Attempt ask{"ask", [&](const Scene&) { return is_enough(confine(needs())) ? 0 : 1; }};
  EXPECT_EQ(outcome_of(ask, scene_, [] {}), 0) << "the kernel lacks Landlock or seccomp";
}

TEST_F(Confinement, DeniesEveryAttemptInAllLayers) {
  for (const Attempt& attempt : attempts()) {
    const int outcome = outcome_of(attempt, scene_, [&] { static_cast<void>(confine(needs())); });
    EXPECT_THAT(outcome, testing::AnyOf(EPERM, EACCES, ENOSYS)) << attempt.name;
  }
  expect_nothing_happened();
}

TEST_F(Confinement, DeniesByTheFilterAloneWhatTheFilterSees) {
  for (const Attempt& attempt : attempts()) {
    if (!attempt.system_calls) continue;
    const int outcome = outcome_of(attempt, scene_, [] { static_cast<void>(restrict_system_calls()); });
    EXPECT_THAT(outcome, testing::AnyOf(EPERM, ENOSYS)) << attempt.name;
  }
  expect_nothing_happened();
}

TEST_F(Confinement, DeniesByLandlockAloneWhatLandlockSees) {
  const int version = landlock_version();
  ASSERT_GE(version, 2);
  for (const Attempt& attempt : attempts()) {
    if (attempt.landlock == 0 || attempt.landlock > version) continue;
    const int outcome = outcome_of(attempt, scene_, [&] { static_cast<void>(restrict_files(needs())); });
    EXPECT_THAT(outcome, testing::AnyOf(EPERM, EACCES, EXDEV)) << attempt.name;
  }
  expect_nothing_happened();
}

/// Without layers most attempts succeed: what the others are denied is no merit of the machine.
TEST_F(Confinement, IsWhatDeniesThem) {
  for (const char* name : {"connect by TCP", "read /etc/passwd", "read the store", "start a program",
                           "start a process", "make a file outside"}) {
    const auto attempt = std::ranges::find(attempts(), name, &Attempt::name);
    ASSERT_NE(attempt, attempts().end());
    EXPECT_EQ(outcome_of(*attempt, scene_, [] {}), 0) << name;
  }
}

TEST_F(Confinement, LeavesWhatReadersDo) {
  const Attempt work{"work", [](const Scene& scene) {
                       std::ifstream in{scene.given()};
                       std::string text;
                       if (!(in >> text) || text != "currents") return 1;
                       const fs::path below = scene.staging() / "unpacked";
                       fs::create_directories(below);
                       std::ofstream out{below / "ice.shp"};
                       if (!(out << text << std::flush)) return 2;
                       fs::rename(below / "ice.shp", below / "ice.dbf");
                       if (std::distance(fs::directory_iterator{below}, {}) != 1) return 3;
                       fs::remove_all(below);
                       int sum = 0;
                       std::thread{[&] { sum = 1; }}.join();
                       return sum == 1 ? 0 : 4;
                     }};
  EXPECT_EQ(outcome_of(work, scene_, [&] { static_cast<void>(confine(needs())); }), 0);
  expect_nothing_happened();
}

TEST_F(Confinement, CannotBeTakenOffAgain) {
  const Attempt again{"again", [](const Scene& scene) {
                        static_cast<void>(restrict_files({.read = {"/"}, .write = scene.folder}));
                        return open("/etc/passwd", O_RDONLY | O_CLOEXEC) < 0 ? errno : 0;
                      }};
  EXPECT_EQ(outcome_of(again, scene_, [&] { static_cast<void>(confine(needs())); }), EACCES);
  EXPECT_EQ(outcome_of(again, scene_, [&] { static_cast<void>(restrict_files(needs())); }), EACCES);
}

TEST(Layers, AreEnoughWithTheFilterAndLandlockOfTheFirstKernelThatServes) {
  EXPECT_TRUE(is_enough({.system_calls = true, .landlock = 2}));
  EXPECT_TRUE(is_enough({.system_calls = true, .landlock = 7}));
  EXPECT_FALSE(is_enough({.system_calls = true, .landlock = 1}));
  EXPECT_FALSE(is_enough({.system_calls = true, .landlock = 0}));
  EXPECT_FALSE(is_enough({.system_calls = false, .landlock = 7}));
}

TEST(Layers, AreNamed) {
  EXPECT_EQ(to_text({.system_calls = true, .landlock = 2}), "seccomp, Landlock 2");
  EXPECT_EQ(to_text({.system_calls = false, .landlock = 0}), "no seccomp, no Landlock");
}

}  // namespace
}  // namespace floeplan::sandbox::confinement_test
