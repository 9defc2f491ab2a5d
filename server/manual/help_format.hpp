#pragma once

#include <CLI/CLI.hpp>

namespace floeplan::manual {

/// Has the parser, which has no commands yet, and all commands that it gets, write their help so: commands and flags in
/// groups, of a command with many flags those that most need; all with --help-all; an example at the end.
void prepare_help(CLI::App& app);

/// Puts the registered commands into the groups of `command_helps`; commands that it lacks are not shown.
void group_commands(CLI::App& app);

}  // namespace floeplan::manual
