#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "tests/support/places.hpp"

namespace floeplan::cli::faults_test {
namespace {

/// A dozen kills, a full disk, a store that cannot be written or is damaged, and too little memory, by the script that
/// also does it hundreds of times (deploy/test.sh --full). Takes longer than other tests: a server starts some twenty
/// times.
TEST(Faults, LoseNothingThatWasPromised) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "install the package python3 to run this test";
  const std::string command = "PYTHONDONTWRITEBYTECODE=1 python3 " + support::source_folder() +
                              "/tests/faults/faults.py " + support::program_folder() + "/floeplan --kills 12";
  EXPECT_EQ(std::system(command.c_str()), 0) << "what was lost is printed above";
}

/// A few kills of nodes that share a store, and of the database server below them, by the script that also does it
/// hundreds of times.
TEST(NodeFaults, LoseNoJobThatWasPromised) {
  const std::string command = "PYTHONDONTWRITEBYTECODE=1 python3 " + support::source_folder() +
                              "/tests/faults/lost_nodes.py " + support::program_folder() +
                              "/floeplan --jobs 300 --kills 8";
  const int status = std::system(command.c_str());
  constexpr int skipped = 77;
  if (WIFEXITED(status) && WEXITSTATUS(status) == skipped) GTEST_SKIP() << "PostgreSQL is not installed";
  EXPECT_EQ(status, 0) << "what was lost is printed above";
}

}  // namespace
}  // namespace floeplan::cli::faults_test
