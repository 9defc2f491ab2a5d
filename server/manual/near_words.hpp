#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::manual {

/// The one of the words that was probably meant: a third of its letters may be wrong, left out, too many or in the
/// wrong order. Of several as near the first; empty where none is near.
[[nodiscard]] std::string nearest(std::string_view written, const std::vector<std::string>& words);

/// "there is no command paln; did you mean plan?", once the parser has refused a command line; nothing where it was
/// refused for another reason than an unknown command or flag.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app);

}  // namespace floeplan::manual
