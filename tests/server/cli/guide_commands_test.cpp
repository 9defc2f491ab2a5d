#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "tests/support/places.hpp"

namespace floeplan::cli::guide_commands_test {
namespace {

std::vector<std::string> pages() {
  std::vector<std::string> all{"README.md"};
  const std::filesystem::path root = support::source_folder();
  for (const auto& entry : std::filesystem::directory_iterator{root / "web/guide"})
    if (entry.path().extension() == ".md") all.push_back("web/guide/" + entry.path().filename().string());
  std::ranges::sort(all);
  return all;
}

/// A page that people copy commands from.
class Commands : public testing::TestWithParam<std::string> {};

TEST_P(Commands, OfAPageRunAsTheyStandThere) {
  const std::string script = support::source_folder() + "/tests/server/cli/guide_commands.py";
  const int status = std::system(
      ("python3 " + script + ' ' + support::program_folder() + "/floeplan " + GetParam()).c_str());

  constexpr int something_is_not_installed = 77;
  if (WEXITSTATUS(status) == something_is_not_installed) GTEST_SKIP() << "see what is printed above";
  EXPECT_EQ(status, 0) << "what went wrong is printed above";
}

INSTANTIATE_TEST_SUITE_P(Guide, Commands, testing::ValuesIn(pages()), [](const auto& page) {
  std::string name = std::filesystem::path{page.param}.stem();
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return page.param == "README.md" ? "Top" + name : name;
});

}  // namespace
}  // namespace floeplan::cli::guide_commands_test
