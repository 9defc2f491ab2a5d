#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// A line of a Seaglider's file that is not a comment.
struct SeagliderLine {
  int number{};
  std::vector<std::string_view> words;

  /// The two parts of a word such as "lat=4807.5"; empty unless it has exactly one equals sign and text on
  /// both sides.
  [[nodiscard]] static std::optional<std::pair<std::string_view, std::string_view>> field(
      std::string_view word);
};

/// The lines of a file of the shore station that are not empty or comments, in order. Comment lines begin
/// with '/'. Stores all lines in the document. Characters outside ASCII give errors, in comments warnings.
/// `text`    borrowed by the lines
/// Source    iop-apl-uw/basestation3 validate.py
[[nodiscard]] std::vector<SeagliderLine> seaglider_lines(const FileText& text, Document& document);

}  // namespace floeplan::mission
