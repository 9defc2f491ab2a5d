#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace floeplan::manual {

/// A flag or an argument of a command, as a person writes it.
struct Argument {
  std::vector<std::string> names;  // "-h", "--help"; of an argument without a flag its one name, "FILE"
  std::string value;               // what stands behind the flag, "LON,LAT"; empty: nothing
  std::string help;
  std::string group;  // heading in the help
};

/// A command that is registered on the parser.
struct Command {
  std::string path;  // with those above it, "datasets prune"; of the program itself empty
  std::string description;
  std::vector<Argument> arguments;
  std::vector<Argument> flags;
  std::vector<std::string> commands;  // below it, by their names
};

/// The program itself and all commands that its help shows, each before those below it.
[[nodiscard]] std::vector<Command> commands_of(const CLI::App& app);

/// What stands behind a flag: "LON,LAT", "NUMBER", "up|down"; empty where it takes nothing.
[[nodiscard]] std::string value_of(const CLI::Option& option);

/// The purpose of a flag or argument, with its range and default.
[[nodiscard]] std::string help_of(const CLI::Option& option);

/// The innermost command that was given on the command line.
[[nodiscard]] const CLI::App& last_command(const CLI::App& app);

/// The full name of a command, with the commands that contain it.
[[nodiscard]] std::string path_of(const CLI::App& command);

}  // namespace floeplan::manual
