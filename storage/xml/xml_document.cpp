#include "storage/xml/xml_document.hpp"

#include <expat.h>

#include <algorithm>
#include <memory>

#include "engine/core/utf8_text.hpp"

namespace floeplan::xml {
namespace {

constexpr std::size_t deepest = 200;         // nested elements; a document of folders has about twelve
constexpr std::size_t part_bytes = 1 << 20;  // passed to Expat at once, because it counts in int

std::string local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return std::string{colon == std::string_view::npos ? name : name.substr(colon + 1)};
}

/// The document that Expat's handlers build.
struct Building {
  XML_Parser parser;
  Element root;
  std::vector<Element*>
      open;  // from the root to the current element; a parent's children do not grow meanwhile
  std::string fault;

  void stop(std::string reason) {
    if (fault.empty()) fault = std::move(reason);
    XML_StopParser(parser, XML_FALSE);
  }
};

int line_of(XML_Parser parser) { return static_cast<int>(XML_GetCurrentLineNumber(parser)); }

void begin_element(void* data, const char* name, const char** attributes) {
  Building& building = *static_cast<Building*>(data);
  if (building.open.size() == deepest)
    return building.stop("nests more than " + std::to_string(deepest) + " elements within each other");
  Element element{local_name(name), {}, {}, line_of(building.parser), {}};
  for (; *attributes != nullptr; attributes += 2)
    element.attributes.emplace(local_name(attributes[0]), attributes[1]);
  if (building.open.empty()) {
    building.root = std::move(element);
    building.open.push_back(&building.root);
  } else {
    auto& siblings = building.open.back()->children;
    siblings.push_back(std::move(element));
    building.open.push_back(&siblings.back());
  }
}

void end_element(void* data, const char* /*name*/) { static_cast<Building*>(data)->open.pop_back(); }

void add_text(void* data, const char* text, int length) {
  Building& building = *static_cast<Building*>(data);
  if (!building.open.empty()) building.open.back()->text.append(text, static_cast<std::size_t>(length));
}

constexpr const char* own_entities =
    "declares entities of its own, which this program does not take; save it without a DTD";

void refuse_entity(void* data, const char* /*name*/, int /*is_parameter*/, const char* /*value*/,
                   int /*length*/, const char* /*base*/, const char* /*system*/, const char* /*of_public*/,
                   const char* /*notation*/) {
  static_cast<Building*>(data)->stop(own_entities);
}

void refuse_skipped_entity(void* data, const char* name, int /*is_parameter*/) {
  static_cast<Building*>(data)->stop("uses the entity \"" + std::string{name} +
                                     "\" of a DTD, which is not looked up");
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string root_name(std::string_view head) {
  while ((head = trimmed(head)).starts_with("<")) {
    const bool is_comment = head.starts_with("<!--");
    if (!is_comment && !head.starts_with("<?") && !head.starts_with("<!")) {
      head.remove_prefix(1);
      return local_name(head.substr(0, head.find_first_of(" \t\r\n/>")));
    }
    const std::size_t subset =
        head.find('[');  // start of a DOCTYPE's declarations, which contain their own '>'
    const bool has_subset = !is_comment && subset < head.find('>');
    const std::string_view end = is_comment ? "-->" : ">";
    const std::size_t at = head.find(end, has_subset ? head.find(']', subset) : 0);
    if (at == std::string_view::npos) return {};
    head.remove_prefix(at + end.size());
  }
  return {};
}

const Element* Element::child(std::string_view wanted) const {
  const auto found = std::ranges::find(children, wanted, &Element::name);
  return found == children.end() ? nullptr : &*found;
}

std::string Element::text_of(std::string_view wanted) const {
  const Element* const found = child(wanted);
  return found == nullptr ? "" : std::string{trimmed(found->text)};
}

std::string Element::attribute(std::string_view wanted) const {
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? "" : found->second;
}

tl::expected<Element, std::string> parse(std::string_view bytes) {
  std::string text = core::utf8_text(bytes);
  // A document from a JSON text is UTF-8, whatever it declares.
  const char* const encoding = core::is_utf8(text) ? "UTF-8" : nullptr;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser{XML_ParserCreate(encoding),
                                                                            &XML_ParserFree};
  Building building{parser.get(), {}, {}, {}};
  XML_SetUserData(parser.get(), &building);
  XML_SetElementHandler(parser.get(), &begin_element, &end_element);
  XML_SetCharacterDataHandler(parser.get(), &add_text);
  XML_SetEntityDeclHandler(parser.get(), &refuse_entity);
  XML_SetSkippedEntityHandler(parser.get(), &refuse_skipped_entity);
  for (std::size_t at = 0; at == 0 || at < text.size(); at += part_bytes) {
    const std::size_t length = std::min(part_bytes, text.size() - at);
    const int is_last = at + length == text.size() ? 1 : 0;
    if (XML_Parse(parser.get(), text.data() + at, static_cast<int>(length), is_last) == XML_STATUS_OK)
      continue;
    const std::string where = "line " + std::to_string(line_of(parser.get())) + ": ";
    if (!building.fault.empty()) return tl::unexpected(where + "the document " + building.fault);
    return tl::unexpected(where + "this is no sound XML (" + XML_ErrorString(XML_GetErrorCode(parser.get())) +
                          "); the file is damaged or was cut short; copy or export it again");
  }
  return std::move(building.root);
}

}  // namespace floeplan::xml
