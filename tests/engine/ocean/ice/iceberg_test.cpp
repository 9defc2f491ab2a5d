#include "engine/ocean/ice/iceberg.hpp"

#include <gtest/gtest.h>

#include <set>

namespace floeplan::ocean::iceberg_test {
namespace {

using enum IcebergSize;
constexpr IcebergSize all_sizes[] = {growler, bergy_bit,  small,   medium,
                                     large,   very_large, unknown, radar_target};

Iceberg berg(IcebergSize size) {
  Iceberg iceberg;
  iceberg.size = size;
  return iceberg;
}

TEST(SafeLength, IsTheStatedOneWhateverTheClass) {
  Iceberg iceberg = berg(very_large);
  iceberg.length = core::Metres{45.0};

  EXPECT_EQ(safe_length(iceberg).value, 45.0);
}

TEST(SafeLength, IsTheUpperEndOfTheClass) {
  EXPECT_EQ(safe_length(berg(growler)).value, 5.0);
  EXPECT_EQ(safe_length(berg(bergy_bit)).value, 15.0);
  EXPECT_EQ(safe_length(berg(small)).value, 60.0);
  EXPECT_GE(safe_length(berg(medium)).value, 120.0);
  EXPECT_GE(safe_length(berg(large)).value, 200.0);
}

TEST(SafeLength, OfABergOfUnknownSizeIsThatOfAVeryLargeOne) {
  EXPECT_EQ(safe_length(berg(very_large)).value, 300.0);
  EXPECT_EQ(safe_length(berg(unknown)).value, 300.0);
  EXPECT_EQ(safe_length(berg(radar_target)).value, 300.0);
  EXPECT_EQ(safe_length(Iceberg{}).value, 300.0);
}

TEST(SizeName, LeadsBackToItsSize) {
  std::set<std::string> names;
  for (const IcebergSize size : all_sizes) {
    EXPECT_EQ(parse_size(size_name(size)), size);
    EXPECT_TRUE(names.insert(size_name(size)).second);
  }
}

TEST(SizeName, IsNotGuessed) {
  EXPECT_FALSE(parse_size("").has_value());
  EXPECT_FALSE(parse_size("Growler").has_value());
  EXPECT_FALSE(parse_size("huge").has_value());
}

}  // namespace
}  // namespace floeplan::ocean::iceberg_test
