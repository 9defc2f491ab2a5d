#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Limit on the size of files; the largest real one seen has 12 KiB.
inline constexpr std::size_t max_file_bytes = 64UL * 1024;

/// The lines of a file, decoded to UTF-8, without line ends and byte order mark.
struct FileText {
  std::vector<std::string> lines;
  FileFormat format;
  bool byte_order_mark{};
};

/// Decodes a file: as UTF-8 if it is valid, otherwise as ISO-8859-1. LF, CRLF and CR end a line. A DOS
/// end-of-file character (control-Z) at the end is dropped.
/// Errors   one message for a file that is too large, or that contains NUL and so is not text
[[nodiscard]] tl::expected<FileText, Message> decode_file(std::string_view bytes);

}  // namespace floeplan::mission
