#include <gtest/gtest.h>

#include <cstdlib>

namespace floeplan::cli::faults_test {
namespace {

/// A dozen kills, a full disk, a store that cannot be written or is damaged, and too little memory, by the script that
/// also does it hundreds of times (deploy/test.sh --full). Takes longer than other tests: a server starts some twenty
/// times.
TEST(Faults, LoseNothingThatWasPromised) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "install the package python3 to run this test";
  const char* const command = "PYTHONDONTWRITEBYTECODE=1 python3 " FLOEPLAN_SOURCE_DIR
                              "/tests/faults/faults.py " FLOEPLAN_BINARY_DIR "/floeplan --kills 12";
  EXPECT_EQ(std::system(command), 0) << "what was lost is printed above";
}

}  // namespace
}  // namespace floeplan::cli::faults_test
