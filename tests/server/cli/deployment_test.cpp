#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::deployment_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe{popen(command.c_str(), "r"), &pclose};
  std::string text;
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) text += static_cast<char>(c);
  return text;
}

/// An empty or relative element of this path would be the current folder.
TEST(BuiltPrograms, LookForLibrariesWhereTheSystemHasThemAlone) {
  for (const char* const program : {"floeplan", "ingest_reader"}) {
    const std::string dynamic =
        output_of("readelf --dynamic --wide " + support::program_folder() + "/" + program);
    ASSERT_THAT(dynamic, HasSubstr("NEEDED")) << program;
    EXPECT_THAT(dynamic, Not(HasSubstr("RUNPATH"))) << program;
    EXPECT_THAT(dynamic, Not(HasSubstr("RPATH"))) << program;
  }
}

/// systemd refuses every call that is not named, and a reader that cannot confine itself reads nothing.
TEST(SystemdUnit, LeavesReadersOfFilesTheCallsThatConfineThem) {
  std::ifstream unit{support::source_folder() + "/deploy/floeplan.service"};
  std::string filter;
  for (std::string line; std::getline(unit, line);)
    if (line.starts_with("SystemCallFilter=")) filter += line + ' ';
  for (const char* const call : {"@system-service ", "landlock_create_ruleset ", "landlock_add_rule ",
                                 "landlock_restrict_self ", "seccomp "})
    EXPECT_THAT(filter, HasSubstr(call));
}

TEST(Server, SaysWhatConfinesItsReaders) {
  const support::TemporaryFolder store;
  const support::ServedProgram served{store.path()};
  const auto readiness = served.get("/readyz").json();
  EXPECT_EQ(readiness["status"], "ok");
  EXPECT_EQ(readiness["sandbox"]["enough"], true);
  EXPECT_THAT(readiness["sandbox"]["layers"].get<std::string>(), HasSubstr("seccomp, Landlock "));
}

}  // namespace
}  // namespace floeplan::deployment_test
