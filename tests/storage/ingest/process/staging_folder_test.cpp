#include "storage/ingest/process/staging_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace floeplan::ingest::staging_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(StagingFolder, IsRemovedWithEverythingInIt) {
  const support::TemporaryFolder folder;
  fs::path path;
  {
    const StagingFolder staging{folder.path()};
    path = staging.path();
    std::ofstream{path / "part"} << "of a file";
    EXPECT_TRUE(fs::is_directory(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(StagingFolder, OfAKilledProcessIsRemovedAndThatOfALivingOneIsNot) {
  const support::TemporaryFolder folder;
  const StagingFolder living{folder.path()};
  const fs::path abandoned = folder.path() / "killed";
  fs::create_directories(abandoned);
  std::ofstream{abandoned / "part"} << "of a file";

  StagingFolder::remove_abandoned(folder.path());

  EXPECT_FALSE(fs::exists(abandoned));
  EXPECT_TRUE(fs::is_directory(living.path()));
}

TEST(StagingFolder, ThatOthersLeftNeedsNoParentToBeRemoved) {
  const support::TemporaryFolder folder;
  StagingFolder::remove_abandoned(folder.path() / "incoming");
  EXPECT_FALSE(fs::exists(folder.path() / "incoming"));
}

}  // namespace
}  // namespace floeplan::ingest::staging_folder_test
