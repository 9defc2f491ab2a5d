#pragma once

#include <CLI/CLI.hpp>

namespace floeplan::cli {

/// Adds the flag --instructions, which no help shows: the instructions that searches use of those that the processor has.
/// Plans do not depend on it; the flag is there to show that.
void add_instructions(CLI::App& app);

}  // namespace floeplan::cli
