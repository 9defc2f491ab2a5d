#pragma once

#include <CLI/CLI.hpp>

namespace floeplan::manual {

/// Sets the format of the help for the program and all commands that are added later: commands and flags in groups; for
/// a command with many flags only the important ones, with --help-all all; an example at the end. Call it before adding
/// commands.
void prepare_help(CLI::App& app);

/// Puts the registered commands into the groups of `command_helps`; commands that are not listed there are
/// hidden.
void group_commands(CLI::App& app);

}  // namespace floeplan::manual
