#include "engine/core/shown_text.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/property.hpp"

namespace floeplan::core::shown_text_test {
namespace {

const std::string secret = "0123456789abcdef_" + std::string(64, 'e');
const std::string token = "floeplan_" + secret;

std::string percent_encoded(const std::string& text, std::mt19937_64& rng) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (rng() % 2 == 0) {
      result += std::string{"%"} + digits[byte >> 4U] + digits[byte & 15U];
    } else {
      result += c;
    }
  }
  return result;
}

std::string fully_decoded(std::string text) {
  for (std::size_t at = 0; (at = text.find('%')) != std::string::npos;)
    text.replace(at, 3, 1, static_cast<char>(std::stoi(text.substr(at + 1, 2), nullptr, 16)));
  return text;
}

TEST(WithoutSecrets, HidesCredentialsAndLeavesTheRest) {
  EXPECT_EQ(without_secrets("a " + token + " b"), "a floeplan_(hidden) b");
  EXPECT_EQ(without_secrets("authorization: BEARER abcdefghi"), "authorization: BEARER (hidden)");
  EXPECT_EQ(without_secrets("floeplan_session=x; a=1"), "floeplan_session=(hidden); a=1");
  EXPECT_EQ(without_secrets("floeplan_http_requests_total 5"), "floeplan_http_requests_total 5");
  EXPECT_EQ(without_secrets("the bearer of this"), "the bearer of this");
}

TEST(ShownTarget, HidesValuesOfParametersThatSpeakOfSecrets) {
  EXPECT_EQ(shown_target("/datasets?token=abc&limit=3"), "/datasets?token=(hidden)&limit=3");
  EXPECT_EQ(shown_target("/?Api%4Bey=abc"), "/?Api%4Bey=(hidden)");
  EXPECT_EQ(shown_target("/edr/x?coords=POINT(1%202)&f=json"), "/edr/x?coords=POINT(1%202)&f=json");
  EXPECT_EQ(shown_target("/" + std::string(1000, 'a')).size(), 300U);
}

TEST(ShownTarget, HidesCredentialsWhereverTheyStandHoweverTheyAreEncoded) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    std::string sent = token;
    for (std::uint64_t layers = rng() % 4; layers > 0; --layers) sent = percent_encoded(sent, rng);
    for (const std::string& target : {"/" + sent + "/x", "/a?" + sent, "/a?b=" + sent, "/a?" + sent + "=b",
                                      "/" + std::string(250, 'a') + "?b=" + sent}) {
      const std::string shown = fully_decoded(shown_target(target));
      EXPECT_EQ(shown.find("eeeeeeee"), std::string::npos) << target << '\n' << shown;
    }
  });
}

TEST(Excerpt, CutsWordsThatNobodyReads) {
  EXPECT_EQ(excerpt("No plan p1 is stored."), "No plan p1 is stored.");
  EXPECT_EQ(excerpt("No plan " + std::string(1'000'000, 'x') + " is stored."),
            "No plan " + std::string(60, 'x') + "... (1000000 characters) is stored.");
  std::string words;
  for (int i = 0; i < 100'000; ++i) words += "word ";
  EXPECT_LT(excerpt(words).size(), 2100U);
}

TEST(ShortenedList, NamesTenAndCountsTheOthers) {
  EXPECT_EQ(shortened_list({}), "");
  EXPECT_EQ(shortened_list({"B-1", "B-2"}), "B-1, B-2");
  EXPECT_EQ(shortened_list({"1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"}),
            "1, 2, 3, 4, 5, 6, 7, 8, 9, 10 and 2 more");
}

TEST(DistanceText, IsInMetresBelowOneKilometre) {
  EXPECT_EQ(distance_text(Metres{136.4}), "136 m");
  EXPECT_EQ(distance_text(Metres{999.6}), "1.0 km");
  EXPECT_EQ(distance_text(Metres{8260.0}), "8.3 km");
  EXPECT_EQ(distance_text(Metres{142'300.0}), "142 km");
}

}  // namespace
}  // namespace floeplan::core::shown_text_test
