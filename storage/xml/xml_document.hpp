#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace floeplan::xml {

/// An element of an XML document. Names are without their namespace prefix.
struct Element {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  // its own text in UTF-8, without the text of its children
  int line{};        // line of its start tag, from 1
  std::vector<Element> children;

  /// The first child with this name; null if there is none.
  [[nodiscard]] const Element* child(std::string_view wanted) const;
  /// The text of that child without blanks at both ends; empty if there is none.
  [[nodiscard]] std::string text_of(std::string_view wanted) const;
  /// The attribute with this name; empty if there is none.
  [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/// Parses a whole document: UTF-8, UTF-16, or another declared encoding that Expat knows.
/// Errors   the fault with its line: not XML, cut short, nested deeper than 200 elements, own entities.
///          Entities are refused because they could make a small document huge or refer to other files; none
///          is ever resolved
[[nodiscard]] tl::expected<Element, std::string> parse(std::string_view bytes);

/// The name of a text's first element without its prefix; empty if the text is not XML. `head` may be cut
/// short.
[[nodiscard]] std::string root_name(std::string_view head);

/// The text without blanks, tabs and line ends at both sides.
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace floeplan::xml
