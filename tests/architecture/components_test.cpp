#include "tests/architecture/components.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "tests/support/places.hpp"

namespace floeplan::support::components_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

constexpr int most_code_files = 40;  // the largest number that a reader can survey

TEST(Components, IncludeEachOtherInNoRing) {
  EXPECT_THAT(include_rings(source_folder()), testing::IsEmpty());
}

TEST(Components, OfARingAreNamed) {
  const fs::path root = fs::path{testing::TempDir()} / ("rings_" + std::to_string(::getpid()));
  for (const char* layer : {"engine/geo", "storage", "api", "server"}) fs::create_directories(root / layer);
  std::ofstream{root / "engine/geo/a.hpp"} << "#include \"engine/geo/b.hpp\"\n";
  std::ofstream{root / "engine/geo/b.hpp"} << "#pragma once\n";
  std::ofstream{root / "engine/geo/b.cpp"}
      << "#include \"engine/geo/b.hpp\"\n#include \"engine/geo/c.hpp\"\n";
  std::ofstream{root / "engine/geo/c.hpp"} << "#include \"engine/geo/a.hpp\"\n";
  std::ofstream{root / "engine/geo/d.hpp"} << "#include \"engine/geo/a.hpp\"\n";
  EXPECT_THAT(include_rings(root), ElementsAre("engine/geo/a engine/geo/b engine/geo/c"));
  fs::remove_all(root);
}

TEST(Folders, SayInTenLinesWhatTheyAreFor) {
  constexpr int most_lines = 10;
  for (const char* layer : {"engine", "storage", "api", "server"}) {
    for (const auto& folder : fs::directory_iterator{fs::path{source_folder()} / layer}) {
      if (!folder.is_directory()) continue;
      std::ifstream readme{folder.path() / "README.md"};
      EXPECT_TRUE(readme.is_open()) << folder.path() << " has no README.md";
      int lines = 0;
      for (std::string line; std::getline(readme, line);) ++lines;
      EXPECT_LE(lines, most_lines) << folder.path();
    }
  }
}

TEST(Folders, HoldAtMostFortyCodeFiles) {
  for (const auto& [folder, count] : code_files_by_folder(source_folder()))
    EXPECT_LE(count, most_code_files) << folder << ": divide it into rooms";
}

}  // namespace
}  // namespace floeplan::support::components_test
