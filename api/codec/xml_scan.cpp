#include "api/codec/xml_scan.hpp"

#include <algorithm>

namespace floeplan::codec {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// `document` from behind `end`, or nothing left where that does not come.
std::size_t behind(std::string_view document, std::string_view end, std::size_t from) {
  const std::size_t at = document.find(end, from);
  return at == std::string_view::npos ? document.size() : at + end.size();
}

std::string local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return std::string{colon == std::string_view::npos ? name : name.substr(colon + 1)};
}

std::map<std::string, std::string> attributes_of(std::string_view text) {
  std::map<std::string, std::string> attributes;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(blanks, at)) != std::string_view::npos) {
    const std::size_t equals = text.find('=', at);
    if (equals == std::string_view::npos) break;
    const std::size_t open = text.find_first_of("\"'", equals);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) break;
    const std::string_view name = text.substr(at, text.find_last_not_of(blanks, equals - 1) + 1 - at);
    attributes.emplace(local_name(name), std::string{text.substr(open + 1, close - open - 1)});
    at = close + 1;
  }
  return attributes;
}

/// The end of a tag, past any '>' between quotes.
std::size_t tag_end(std::string_view document, std::size_t from) {
  char quote = '\0';
  for (std::size_t i = from; i < document.size(); ++i) {
    const char c = document[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i;
    }
  }
  return document.size();
}

}  // namespace

std::vector<XmlElement> scan_xml(std::string_view document) {
  std::vector<XmlElement> elements;
  int line = 1;
  std::size_t counted = 0;
  std::size_t at = 0;
  while ((at = document.find('<', at)) != std::string_view::npos) {
    line += static_cast<int>(std::count(document.begin() + static_cast<std::ptrdiff_t>(counted),
                                        document.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    const std::string_view rest = document.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(document, "-->", at);
      continue;
    }
    const std::size_t end = tag_end(document, at + 1);
    if (end == document.size()) break;
    const char first = document[at + 1];
    if (first != '/' && first != '?' && first != '!') {
      const std::string_view tag = document.substr(at + 1, end - at - 1);
      const std::size_t name_end = std::min(tag.find_first_of(" \t\r\n/"), tag.size());
      const std::size_t text_end = std::min(document.find('<', end), document.size());
      elements.push_back({local_name(tag.substr(0, name_end)), attributes_of(tag.substr(name_end)),
                          std::string{document.substr(end + 1, text_end - end - 1)}, line});
    }
    at = end + 1;
  }
  return elements;
}

}  // namespace floeplan::codec
