#include "api/codec/bytes/multipart.hpp"

#include <gmock/gmock.h>

#include "tests/support/property.hpp"

namespace floeplan::codec::multipart_test {
namespace {

using testing::HasSubstr;

const std::string type = "multipart/form-data; boundary=XX";

TEST(Multipart, GivesEachFileAsItsBytesCame) {
  const auto parts =
      parse_multipart("multipart/form-data; charset=utf-8; boundary=\"XX\"",
                      "a preamble\r\n--XX\r\n"
                      "Content-Disposition: form-data; name=\"f\"; filename=\"a \\\"b\\\".ma\"\r\n"
                      "Content-Type: application/octet-stream\r\n\r\n"
                      "one\r\n--X\xff\r\n\r\n"
                      "--XX\r\ncontent-disposition: form-data; filename=b.ma; name=f\r\n\r\n\r\n"
                      "--XX--\r\nan epilogue");

  ASSERT_TRUE(parts.has_value()) << parts.error();
  ASSERT_EQ(parts->size(), 2U);
  EXPECT_EQ((*parts)[0].name, "f");
  EXPECT_EQ((*parts)[0].file_name, "a \"b\".ma");
  EXPECT_EQ((*parts)[0].content, "one\r\n--X\xff\r\n");
  EXPECT_EQ((*parts)[1].file_name, "b.ma");
  EXPECT_EQ((*parts)[1].content, "");
}

TEST(Multipart, SaysWhatIsWrong) {
  EXPECT_THAT(parse_multipart("multipart/form-data", "--XX--").error(), HasSubstr("no boundary"));
  EXPECT_THAT(parse_multipart(type, "nothing").error(), HasSubstr("does not hold"));
  EXPECT_THAT(parse_multipart(type, "--XX\r\nContent-Disposition: form-data; name=f\r\n\r\ncut").error(),
              HasSubstr("closing"));
  EXPECT_THAT(parse_multipart(type, "--XX\r\nname=f\r\n\r\n\r\n--XX--").error(), HasSubstr("Disposition"));
  EXPECT_THAT(parse_multipart(type, "--XX\r\n\r\nno headers\r\n--XX--").error(), HasSubstr("Disposition"));
  EXPECT_THAT(parse_multipart(type, "--XX\r\n--XX--").error(), HasSubstr("empty line"));
}

TEST(Multipart, SurvivesAnyDamage) {
  const std::string sound =
      "--XX\r\nContent-Disposition: form-data; name=\"f\"; filename=\"a.ma\"\r\n\r\nb_arg: x(m) "
      "1\r\n--XX--\r\n";
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    std::string body = sound;
    std::string header = type + "; x=\"y\\\"z\"";
    for (int i = support::uniform_int(rng, 1, 8); i > 0; --i) {
      std::string& hit = support::uniform_int(rng, 0, 3) == 0 ? header : body;
      const auto at =
          static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(hit.size()) - 1));
      if (support::uniform_int(rng, 0, 1) == 0) {
        hit.erase(at, static_cast<std::size_t>(support::uniform_int(rng, 1, 9)));
      } else {
        hit.insert(at, 1, "-X\r\n\";=\\"[support::uniform_int(rng, 0, 7)]);
      }
      if (hit.empty()) return;
    }
    const auto parts = parse_multipart(header, body);
    EXPECT_TRUE(parts.has_value() || !parts.error().empty());
  });
}

}  // namespace
}  // namespace floeplan::codec::multipart_test
