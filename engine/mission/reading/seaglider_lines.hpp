#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// A line of a Seaglider's file that is no comment.
struct SeagliderLine {
  int number{};
  std::vector<std::string_view> words;

  /// "lat=4807.5" as its two parts; nothing for a word without one equals sign and something on either side.
  [[nodiscard]] static std::optional<std::pair<std::string_view, std::string_view>> field(
      std::string_view word);
};

/// The lines of a file of the shore station that say something, in their order. Comments begin with '/' at the start
/// of a line. Keeps all lines in the document; characters beyond ASCII are errors, in comments warnings.
/// `text`    is borrowed by the lines
/// Source    iop-apl-uw/basestation3 validate.py
[[nodiscard]] std::vector<SeagliderLine> seaglider_lines(const FileText& text, Document& document);

}  // namespace floeplan::mission
