#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace floeplan::manual {

/// Why the parser refused a command line: one sentence that names the flag or argument and where to find
/// help, "--runs must be from 1 to 10000, not 0; see floeplan simulate --help".
[[nodiscard]] std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

}  // namespace floeplan::manual
