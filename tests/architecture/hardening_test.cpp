#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <string>

#include "tests/support/places.hpp"

namespace floeplan::support::hardening_test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// The output of readelf for the built program.
std::string read_program(const std::string& flags) {
  const std::string command =
      "LC_ALL=C readelf -W " + flags + " " + support::program_folder() + "/floeplan 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 65536> bytes{};
  for (std::size_t count = 0; (count = fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    text.append(bytes.data(), count);
  return pclose(pipe) == 0 ? text : "";
}

/// The protections of the program as shipped; builds with sanitizers or for a debugger have others.
class Hardening : public testing::Test {
 protected:
  void SetUp() override {
    if (read_program("-h").empty()) GTEST_SKIP() << "needs the program, and readelf of the package binutils";
  }
};

TEST_F(Hardening, PutsTheProgramAtAnotherAddressEachTime) {
  EXPECT_THAT(read_program("-h"), ContainsRegex("Type: +DYN"));
  EXPECT_THAT(read_program("-d"), ContainsRegex("FLAGS_1.*PIE"));
}

TEST_F(Hardening, MakesTheLoadersTablesReadOnlyAndNoMemoryBothWritableAndExecutable) {
  const std::string segments = read_program("-l");
  EXPECT_THAT(segments, HasSubstr("GNU_RELRO"));
  EXPECT_THAT(segments, ContainsRegex("GNU_STACK .* RW +0x"));
  EXPECT_THAT(segments, Not(HasSubstr(" RWE ")));
  EXPECT_THAT(read_program("-d"), ContainsRegex("FLAGS_1.*NOW"));
}

TEST_F(Hardening, LooksForLibrariesWhereTheSystemKeepsThemAlone) {
  EXPECT_THAT(read_program("-d"), Not(ContainsRegex("RUNPATH|RPATH")));
}

TEST_F(Hardening, ChecksItsStackAndTheLengthsOfWhatItCopies) {
  const std::string symbols = read_program("--dyn-syms");
  EXPECT_THAT(symbols, HasSubstr("__stack_chk_fail"));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_THAT(symbols, ContainsRegex("__[a-z]+_chk@"));
#endif
}

/// The option leaves no symbol in the program, so the test reads the compiler options in the build's list.
TEST(HardeningOptions, TouchEveryPageOfALargeStackFrame) {
  const std::string list = support::program_folder() + "/build.ninja";
  FILE* file = fopen(list.c_str(), "r");
  if (file == nullptr) GTEST_SKIP() << "built by another generator than ninja";
  std::string text;
  std::array<char, 65536> bytes{};
  for (std::size_t count = 0; (count = fread(bytes.data(), 1, bytes.size(), file)) > 0;)
    text.append(bytes.data(), count);
  fclose(file);
  for (const char* library : {"floeplan_cli", "floeplan_ingest", "floeplan_planning", "floeplan_http"}) {
    const auto at = text.find(std::string{"Order-only phony target for "} + library + "\n");
    ASSERT_NE(at, std::string::npos) << library;
    const auto flags = text.find("  FLAGS = ", at);
    EXPECT_THAT(text.substr(flags, text.find('\n', flags) - flags), HasSubstr("-fstack-clash-protection"))
        << library;
  }
}

}  // namespace
}  // namespace floeplan::support::hardening_test
