#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::manual {

/// The word that was probably meant: at most a third of its letters are wrong, missing, added or swapped. Of
/// several equally near words the first; empty if none is near.
[[nodiscard]] std::string nearest(std::string_view written, const std::vector<std::string>& words);

/// The message for an unknown command or flag, after the parser has refused a command line: "there is no
/// command paln; did you mean plan?"; nullopt if it was refused for another reason.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace floeplan::manual
