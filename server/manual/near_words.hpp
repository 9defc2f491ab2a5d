#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace floeplan::manual {

/// The message for an unknown command or flag, after the parser has refused a command line: `there is no
/// command "paln"; did you mean "plan"?`; nullopt if it was refused for another reason.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace floeplan::manual
