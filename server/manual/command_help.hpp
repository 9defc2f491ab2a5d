#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace floeplan::manual {

/// What the help says of a command besides its flags.
struct CommandHelp {
  std::string_view command;  // with those above it, as "datasets prune"
  std::string_view group;    // heading in the list of all commands; of one below another empty
  std::string_view example;  // behind "floeplan "
  std::vector<std::string_view> needed_most{};  // of a command with many flags; --help-all shows the others
};

/// Every command that the help shows, as it orders them.
[[nodiscard]] std::span<const CommandHelp> command_helps();

/// The help of a command by its full name, as "datasets prune"; null for a command that the help does not show.
[[nodiscard]] const CommandHelp* help_of_command(std::string_view command);

}  // namespace floeplan::manual
