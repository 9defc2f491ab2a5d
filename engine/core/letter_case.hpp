#pragma once

#include <string>
#include <string_view>

namespace floeplan::core {

/// Letters of ASCII in lower case, everything else as it is.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace floeplan::core
