#include "server/cli/program/flag_values.hpp"

#include <gtest/gtest.h>

namespace floeplan::cli::flag_values_test {
namespace {

TEST(FlagValues, ReadAPlaceLongitudeFirst) {
  EXPECT_EQ(parse_place("-53.2,69.25"), (geo::LonLat{-53.2, 69.25}));
  EXPECT_EQ(parse_place("+10,0"), (geo::LonLat{10.0, 0.0}));
}

TEST(FlagValues, RefuseWhatIsNotTwoFiniteNumbers) {
  for (const char* text : {"", ",", "1", "1,2,3", "1;2", "1, 2", "nan,69", "1e999,2", "69N,53W", "1,2 "}) {
    EXPECT_FALSE(parse_place(text).has_value()) << text;
  }
}

TEST(FlagValues, SplitAtEveryComma) {
  EXPECT_EQ(split_at_commas("a,b,,c"), (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_EQ(split_at_commas("one"), (std::vector<std::string>{"one"}));
}

TEST(FlagValues, TakeSecondsOrADuration) {
  const CLI::Validator check = seconds_or_duration();
  std::string seconds{"1.5"};
  std::string duration{"PT1H30M"};
  std::string neither{"1 hour"};

  EXPECT_EQ(check(seconds), "");
  EXPECT_EQ(check(duration), "");
  EXPECT_NE(check(neither), "");

  EXPECT_EQ(seconds, "1.5");
  EXPECT_EQ(std::stod(duration), 5'400.0);
}

}  // namespace
}  // namespace floeplan::cli::flag_values_test
