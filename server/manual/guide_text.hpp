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

/// All pages that the front page of the guide, web/guide/README.md, lists, in its order.
[[nodiscard]] std::span<const GuideText> guide_texts();

}  // namespace floeplan::manual
