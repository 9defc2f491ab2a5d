#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace floeplan::mission {

/// A user's text made safe for one comment line of a mission file: only printable ASCII, runs of blanks as
/// one, at most
/// `max_length` characters. Line breaks and control characters are removed, so that no text can insert a
/// `b_arg:` line.
[[nodiscard]] std::string comment_text(std::string_view text, std::size_t max_length);

}  // namespace floeplan::mission
