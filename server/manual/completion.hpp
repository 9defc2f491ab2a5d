#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/manual/command_list.hpp"

namespace floeplan::manual {

/// The shells that `completion` knows.
[[nodiscard]] std::vector<std::string> shells();

/// A script that completes commands, flags and files for one of the shells.
/// Errors   std::invalid_argument for another shell
[[nodiscard]] std::string completion(std::string_view shell, std::span<const Command> commands);

}  // namespace floeplan::manual
