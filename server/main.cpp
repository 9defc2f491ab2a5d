#include <csignal>
#include <string>

#include "engine/core/version.hpp"
#include "server/cli/run.hpp"
#include "server/commit.hpp"

namespace {

/// "floeplan 0.2.0 (62e0624)": the text that identifies the program in a bug report.
std::string version_line() {
  const std::string commit = floeplan::server::commit();
  return std::string{floeplan::core::program_version()} + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): without memory to build the commands no message can be printed
int main(int argc, char** argv) {
  // Exceeding the file size limit is then reported like a full disk. By default the signal would end the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
  return floeplan::cli::run(argc, argv, version_line());
}
