#pragma once

#include <span>
#include <string_view>

namespace floeplan::manual {

/// A page of the guide as it is written, in Markdown.
struct GuideText {
  std::string_view name;  // "planning"
  std::string_view text;

  /// The words of its first heading.
  [[nodiscard]] std::string_view title() const;
};

/// All pages of web/guide but the front page, by their names.
[[nodiscard]] std::span<const GuideText> guide_texts();

}  // namespace floeplan::manual
