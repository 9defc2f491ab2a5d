#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace floeplan::manual {

/// Words in lines of at most `width` characters. All lines but the first begin with `indent` spaces besides. A word that is
/// longer has a line of its own.
[[nodiscard]] std::string wrapped(std::string_view words, std::size_t width, std::size_t indent = 0);

/// A page of the guide for a terminal: no links, pictures or marks; of a table each row
/// below its head is an item, "first: second; third".
[[nodiscard]] std::string plain_text(std::string_view markdown, std::size_t width);

}  // namespace floeplan::manual
