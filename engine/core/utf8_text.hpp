#pragma once

#include <string>
#include <string_view>

namespace floeplan::core {

/// Whether all bytes are valid UTF-8: no overlong form, no surrogate, no code point above U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view bytes);

/// The text of a file as UTF-8, without its byte order mark. UTF-16 is recognised by its mark, or by a zero
/// byte next to an ASCII character at the beginning.
/// Edges    an unpaired surrogate of UTF-16 becomes U+FFFD; bytes that are not UTF-16 stay unchanged
/// Source   The Unicode Standard, 3.9 and 23.8
[[nodiscard]] std::string utf8_text(std::string_view bytes);

}  // namespace floeplan::core
