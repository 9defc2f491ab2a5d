#include "server/cli/flag_values.hpp"

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

}  // namespace
}  // namespace floeplan::cli::flag_values_test
