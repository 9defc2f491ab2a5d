#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace floeplan::xml {

/// An element of an XML document. Names stand without their namespace prefix.
struct Element {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  // its own, UTF-8, without that of its children
  int line{};        // of its start tag, from 1
  std::vector<Element> children;

  /// The first child of that name; null: there is none.
  [[nodiscard]] const Element* child(std::string_view wanted) const;
  /// The text of that child without blanks at both ends; empty where there is none.
  [[nodiscard]] std::string text_of(std::string_view wanted) const;
  /// Empty where there is none.
  [[nodiscard]] std::string attribute(std::string_view wanted) const;
};

/// Reads a whole document: UTF-8, UTF-16, or another encoding that it declares and Expat knows.
/// Errors   what is wrong, with its line: no XML, cut short, nested deeper than 200 elements; entities of its own, which
///          could make a small document large or name other files: none is ever looked up
[[nodiscard]] tl::expected<Element, std::string> parse(std::string_view bytes);

/// The name of the first element of a text, without its prefix; empty where no XML begins. `head` may be cut short.
[[nodiscard]] std::string root_name(std::string_view head);

/// The text without blanks, tabs and line ends at both sides.
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace floeplan::xml
