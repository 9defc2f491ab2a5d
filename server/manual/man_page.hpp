#pragma once

#include <span>
#include <string>

#include "server/manual/command_list.hpp"

namespace floeplan::manual {

/// The name of a command's man page: "floeplan-datasets-prune"; for the program itself "floeplan".
[[nodiscard]] std::string man_name(const Command& command);

/// The man page of a command, section 1, in the macros of man(7).
/// `all`  all commands, for the section "see also"
[[nodiscard]] std::string man_page(const Command& command, std::span<const Command> all);

}  // namespace floeplan::manual
