#include <csignal>
#include <string>

#include "engine/core/version.hpp"
#include "server/cli/run.hpp"
#include "server/commit.hpp"

namespace {

/// "floeplan 0.2.0 (62e0624)": what a report of a fault has to name.
std::string version_line() {
  const std::string commit = floeplan::server::commit();
  return std::string{floeplan::core::program_version()} + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): with no memory even to build the commands there is nothing to say it with
int main(int argc, char** argv) {
  // A file that may not grow is a full disk, which is said; by default it is a crash.
  std::signal(SIGXFSZ, SIG_IGN);
  return floeplan::cli::run(argc, argv, version_line());
}
