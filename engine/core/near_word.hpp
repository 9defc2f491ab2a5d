#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace floeplan::core {

/// The word that was probably meant: at most a third of its letters are wrong, missing, added or swapped. Of
/// several equally near words the first; empty if none is near.
[[nodiscard]] std::string near_word(std::string_view written, const std::vector<std::string>& words);

}  // namespace floeplan::core
