#pragma once

#include <span>
#include <string_view>

namespace floeplan::manual {

/// A page of the guide in Markdown.
struct GuideText {
  std::string_view name;  // "planning"
  std::string_view text;

  /// The text of its first heading.
  [[nodiscard]] std::string_view title() const;
};

/// All pages of web/guide except the front page, by name.
[[nodiscard]] std::span<const GuideText> guide_texts();

}  // namespace floeplan::manual
