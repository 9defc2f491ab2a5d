#pragma once

#include <string>
#include <string_view>

namespace floeplan::core {

/// Whether the bytes are UTF-8 from end to end: no overlong form, no surrogate, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view bytes);

/// The text of a file as UTF-8, without its byte order mark. UTF-16 is known by its mark, or by a zero beside an ASCII
/// character at its beginning.
/// Edges    half a character of UTF-16 becomes U+FFFD; bytes that are no UTF-16 stay as they are
/// Source   The Unicode Standard, 3.9 and 23.8
[[nodiscard]] std::string utf8_text(std::string_view bytes);

}  // namespace floeplan::core
