#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace floeplan::manual {

/// A flag or an argument of a command, in the user's notation.
struct Argument {
  std::vector<std::string> names;  // "-h", "--help"; for an argument without a flag its name, "FILE"
  std::string value;               // value of the flag, "LON,LAT"; empty: none
  std::string help;
  std::string group;  // heading in the help
};

/// A command that is registered with the parser.
struct Command {
  std::string path;  // with its parent commands, "datasets prune"; empty for the program itself
  std::string description;
  std::vector<Argument> arguments;
  std::vector<Argument> flags;
  std::vector<std::string> commands;  // names of its subcommands
};

/// The program and all commands in its help, each before its subcommands.
[[nodiscard]] std::vector<Command> commands_of(const CLI::App& app);

/// Placeholder for a flag's value: "LON,LAT", "NUMBER", "up|down"; empty if it takes none.
[[nodiscard]] std::string value_of(const CLI::Option& option);

/// The purpose of a flag or argument, with its range and default.
[[nodiscard]] std::string help_of(const CLI::Option& option);

/// The innermost command on the command line.
[[nodiscard]] const CLI::App& last_command(const CLI::App& app);

/// The full name of a command, with its parent commands.
[[nodiscard]] std::string path_of(const CLI::App& command);

}  // namespace floeplan::manual
