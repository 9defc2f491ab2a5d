#pragma once

#include <string>
#include <string_view>

namespace floeplan::core {

/// ASCII letters in lower case, all other bytes unchanged.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Only the ASCII letters and digits of the text, in lower case: makes names of different makers comparable.
[[nodiscard]] std::string plain_word(std::string_view text);

}  // namespace floeplan::core
