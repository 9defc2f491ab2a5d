#pragma once

#include <string>

namespace floeplan::cli {

/// Runs the subcommand that the arguments of `main` name, and returns how the program ends (an `ExitCode`). What is wrong
/// is said on stderr.
/// `version`  the line that --version prints
[[nodiscard]] int run(int argc, char** argv, const std::string& version);

}  // namespace floeplan::cli
