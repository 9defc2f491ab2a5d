#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace floeplan::manual {

/// The words in lines of at most `width` characters. All lines except the first begin with `indent` spaces. A
/// longer word gets a line of its own.
[[nodiscard]] std::string wrapped(std::string_view words, std::size_t width, std::size_t indent = 0);

/// A page of the guide for a terminal: without links, pictures and marks. Each row of a table becomes an
/// item, "first: second; third".
[[nodiscard]] std::string plain_text(std::string_view markdown, std::size_t width);

}  // namespace floeplan::manual
