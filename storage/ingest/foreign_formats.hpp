#pragma once

#include <string>
#include <string_view>

namespace floeplan::ingest {

/// Why a file is refused whose format this program knows but does not read; empty when it may be readable.
[[nodiscard]] std::string refusal_of_foreign(std::string_view head);

}  // namespace floeplan::ingest
