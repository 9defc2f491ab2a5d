#pragma once

#include <string>
#include <string_view>

namespace floeplan::http {

/// A digest of the bytes as hexadecimal digits: equal for equal bytes, and in practice for no others.
[[nodiscard]] std::string entity_tag(std::string_view bytes);

}  // namespace floeplan::http
