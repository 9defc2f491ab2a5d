#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/manual/command_list.hpp"

namespace floeplan::manual {

/// The shells for which the command `completion` has a script.
[[nodiscard]] std::vector<std::string> shells();

/// A text in single quotes of a shell.
[[nodiscard]] std::string quoted(const std::string& text);

/// A script for a shell that completes commands, flags and files.
/// Errors   std::invalid_argument for another shell
[[nodiscard]] std::string completion(std::string_view shell, std::span<const Command> commands);

}  // namespace floeplan::manual
