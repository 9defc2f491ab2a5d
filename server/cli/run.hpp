#pragma once

#include <string>

namespace floeplan::cli {

/// Runs the subcommand in the arguments of `main` and returns the exit code of the program (an `ExitCode`).
/// Errors are printed on stderr.
/// `version`  the line that --version prints
[[nodiscard]] int run(int argc, char** argv, const std::string& version);

}  // namespace floeplan::cli
