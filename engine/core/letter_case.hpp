#pragma once

#include <string>
#include <string_view>

namespace floeplan::core {

/// Letters of ASCII in lower case, everything else as it is.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Letters and digits of ASCII alone, in lower case: how names and words of different makers are compared.
[[nodiscard]] std::string plain_word(std::string_view text);

}  // namespace floeplan::core
