#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace floeplan::manual {

/// Why the parser has refused a command line, in one sentence that names the flag or the argument, and a way out:
/// "--runs must be from 1 to 10000, not 0; see floeplan simulate --help".
[[nodiscard]] std::string usage_fault(const CLI::App& app, const CLI::ParseError& error);

}  // namespace floeplan::manual
