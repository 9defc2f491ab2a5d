#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace floeplan::manual {

/// The help of a command in addition to its flags.
struct CommandHelp {
  std::string_view command;                     // with its parent commands, as "datasets prune"
  std::string_view group;                       // heading in the list of all commands; empty for a subcommand
  std::string_view example;                     // without the leading "floeplan "
  std::vector<std::string_view> needed_most{};  // for a command with many flags; --help-all shows the others
};

/// All commands in the help, in its order.
[[nodiscard]] std::span<const CommandHelp> command_helps();

/// The help of a command with this full name, as "datasets prune"; null if the help does not show it.
[[nodiscard]] const CommandHelp* help_of_command(std::string_view command);

}  // namespace floeplan::manual
