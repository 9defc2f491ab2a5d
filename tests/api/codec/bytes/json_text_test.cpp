#include "api/codec/bytes/json_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace floeplan::codec::json_text_test {
namespace {

using testing::HasSubstr;

TEST(JsonText, RefusesAKeyThatStandsTwiceAndTellsItsPlace) {
  for (const auto& [text, place] :
       {std::pair{R"({"depart": 1, "to": 2, "depart": 3})", "/depart."},
        std::pair{R"({"under_ice": {"margin_below_ice_m": 10, "margin_below_ice_m": 1}})",
                  "/under_ice/margin_below_ice_m."},
        std::pair{R"({"areas": [[1, 2], {"kind": 1}, {"kind": "no_go", "kind": "stay_in"}]})",
                  "/areas/2/kind."}}) {
    const auto parsed = parse_json(text);

    ASSERT_FALSE(parsed.has_value()) << text;
    EXPECT_THAT(parsed.error(), HasSubstr(place));
  }
}

TEST(JsonText, NamesTheBeginningOfAKeyThatNobodyCanRead) {
  const std::string key = '"' + std::string(500'000, 'k') + '"';

  const auto parsed = parse_json("{" + key + ":1," + key + ":2}");

  ASSERT_FALSE(parsed.has_value());
  EXPECT_THAT(parsed.error(), HasSubstr("/kkk"));
  EXPECT_LT(parsed.error().size(), 300U);
}

TEST(JsonText, ReadsTheSameKeyInSeveralObjects) {
  const auto parsed = parse_json(R"({"a": {"x": 1}, "x": [{"x": 2}, {"x": 3}]})");

  ASSERT_TRUE(parsed.has_value()) << parsed.error();
  EXPECT_EQ(parsed->at("x").at(1).at("x"), 3);
}

TEST(JsonText, RefusesWhatIsNestedTooDeeply) {
  const std::string open(max_json_depth + 1, '[');

  const auto parsed = parse_json(open + std::string(max_json_depth + 1, ']'));

  ASSERT_FALSE(parsed.has_value());
  EXPECT_THAT(parsed.error(), HasSubstr("nested"));
}

}  // namespace
}  // namespace floeplan::codec::json_text_test
