#include "storage/xml/xml_document.hpp"

#include <gmock/gmock.h>

#include "engine/core/utf8_text.hpp"
#include "tests/support/property.hpp"

namespace floeplan::xml::xml_document_test {
namespace {

using testing::HasSubstr;

/// The content of a document without line numbers, which must not depend on how the document was written.
std::string summary(const Element& element) {
  std::string text = element.name + "{";
  for (const auto& [name, value] : element.attributes) text += name + "=" + value + ";";
  text += std::string{trimmed(element.text)};
  for (const Element& child : element.children) text += summary(child);
  return text + "}";
}

/// The text as UTF-16, with a byte order mark or without one. It is written from code points, independently of the
/// program.
std::string utf16(const std::u32string& text, bool is_little_endian, bool is_marked) {
  std::string bytes;
  const auto unit = [&](unsigned value) {
    const char low = static_cast<char>(value & 0xFF);
    const char high = static_cast<char>(value >> 8);
    bytes += is_little_endian ? std::string{low, high} : std::string{high, low};
  };
  if (is_marked) unit(0xFEFF);
  for (const char32_t code : text) {
    if (code < 0x10000) {
      unit(static_cast<unsigned>(code));
    } else {
      unit(0xD800 + static_cast<unsigned>((code - 0x10000) >> 10));
      unit(0xDC00 + static_cast<unsigned>((code - 0x10000) & 0x3FF));
    }
  }
  return bytes;
}

TEST(XmlDocument, HoldsElementsTextsAndAttributesWithoutTheirPrefixes) {
  const auto root = parse(
      "<?xml version=\"1.0\"?>\n<!DOCTYPE gpx>\n<g:gpx xmlns:g='u' g:version=\"1.1\">\n"
      "<g:rte><!-- <x/> --><g:name>a &gt; <![CDATA[<b>]]> &#xE9;</g:name></g:rte></g:gpx>");

  ASSERT_TRUE(root.has_value()) << root.error();
  EXPECT_EQ(root->name, "gpx");
  EXPECT_EQ(root->attribute("version"), "1.1");
  ASSERT_NE(root->child("rte"), nullptr);
  EXPECT_EQ(root->child("rte")->line, 4);
  EXPECT_EQ(root->child("rte")->text_of("name"), "a > <b> \xC3\xA9");
  EXPECT_EQ(root->child("trk"), nullptr);
}

TEST(XmlDocument, IsReadAlikeInEveryEncoding) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    std::u32string name;
    constexpr char32_t letters[] = {U'a', U'\u00E9', U'\u20AC', U'\u03A9', U'\U0001F9CA', U' '};
    for (int i = support::uniform_int(rng, 1, 8); i > 0; --i)
      name += letters[support::uniform_int(rng, 0, 4)];
    const std::u32string body = U"<kml><name>" + name + U"</name></kml>";
    const auto expected = parse(core::utf8_text(utf16(body, true, true)));
    ASSERT_TRUE(expected.has_value()) << expected.error();
    for (const bool is_little_endian : {true, false}) {
      for (const bool is_marked : {true, false}) {
        const std::u32string declared = U"<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + body;
        const auto read = parse(utf16(declared, is_little_endian, is_marked));
        ASSERT_TRUE(read.has_value()) << read.error();
        EXPECT_EQ(summary(*read), summary(*expected));
      }
    }
  });
}

TEST(XmlDocument, MayDeclareLatin1AndBeginWithAMark) {
  EXPECT_EQ(parse("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a>\xE9</a>")->text, "\xC3\xA9");
  EXPECT_EQ(parse("\xEF\xBB\xBF<a>\xC3\xA9</a>")->text, "\xC3\xA9");
  EXPECT_EQ(parse("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><a>\xC3\xA9</a>")->text, "\xC3\xA9")
      << "a text that is UTF-8 already, as JSON carries it";
}

TEST(XmlDocument, IsRefusedWithItsLineWhereItIsNotSound) {
  EXPECT_THAT(parse("<a>\n<b></a>").error(), HasSubstr("line 2: this is no sound XML"));
  EXPECT_THAT(parse("<a>\n<b/>").error(), HasSubstr("cut short"));
  EXPECT_THAT(parse("").error(), HasSubstr("cut short"));
  std::string deep;
  for (int i = 0; i < 201; ++i) deep += "<a>";
  EXPECT_THAT(parse(deep).error(), HasSubstr("200 elements"));
}

TEST(XmlDocument, WithEntitiesOfItsOwnIsRefused) {
  std::string bomb = "<!DOCTYPE a [<!ENTITY l0 \"lol\">";
  for (int i = 1; i < 30; ++i)
    bomb += "<!ENTITY l" + std::to_string(i) + " \"&l" + std::to_string(i - 1) + ";&l" +
            std::to_string(i - 1) + ";\">";
  EXPECT_THAT(parse(bomb + "]><a>&l29;</a>").error(), HasSubstr("entities of its own"));
  EXPECT_THAT(parse("<!DOCTYPE a [<!ENTITY f SYSTEM \"file:///etc/passwd\">]><a>&f;</a>").error(),
              HasSubstr("entities of its own"));
  EXPECT_THAT(parse("<!DOCTYPE a SYSTEM \"a.dtd\"><a>&f;</a>").error(), HasSubstr("\"f\""));
}

TEST(XmlDocument, SurvivesBrokenText) {
  const std::string sound =
      "<?xml version='1.0'?><gpx><rte><rtept lat=\"69.25\" lon='-53.5'><name>x</name></rtept></rte></gpx>";
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    std::string text = sound;
    for (int edits = support::uniform_int(rng, 1, 6); edits > 0 && !text.empty(); --edits) {
      const auto at =
          static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(text.size()) - 1));
      if (support::uniform_int(rng, 0, 1) == 0) {
        text.erase(at, static_cast<std::size_t>(support::uniform_int(rng, 1, 9)));
      } else {
        text.insert(at, 1, "<>=\"'/!-? \n\0x"[support::uniform_int(rng, 0, 12)]);
      }
    }
    static_cast<void>(root_name(text));
    const auto read = parse(text);
    EXPECT_TRUE(read || !read.error().empty());
  });
}

TEST(XmlDocument, IsToldByItsFirstElement) {
  EXPECT_EQ(root_name("\n<?xml version='1.0'?>\n<!-- <gpx> -->\n<!DOCTYPE kml>\n<k:kml xmlns:k='u'>"), "kml");
  EXPECT_EQ(root_name("<kml/>"), "kml");
  EXPECT_EQ(root_name("<!DOCTYPE gpx [<!ENTITY a \"b\"><!ENTITY c \"d\">] ><gpx>&a;</gpx>"), "gpx");
  EXPECT_EQ(root_name("<!DOCTYPE gpx [<!ENTITY a \"b\">"), "");
  EXPECT_EQ(root_name("<!-- never ends <kml>"), "");
  EXPECT_EQ(root_name("lon,lat"), "");
}

}  // namespace
}  // namespace floeplan::xml::xml_document_test
