#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::codec {

/// An element of an XML document: its start tag and the text up to the next tag.
struct XmlElement {
  std::string name;  // without its namespace prefix
  std::map<std::string, std::string> attributes;
  std::string text;
  int line{};
};

/// The elements of a document in their order, for formats of which a few elements matter wherever they stand.
/// Comments, declarations and processing instructions are passed over. Entities are left as they are: none is ever
/// looked up, so a document can name no file and grow no larger than it is. What is no XML gives no elements.
[[nodiscard]] std::vector<XmlElement> scan_xml(std::string_view document);

}  // namespace floeplan::codec
