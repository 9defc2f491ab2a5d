#include "engine/core/packed.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace floeplan::core::packed_test {
namespace {

TEST(Packed, KeepsEveryBitOfANumber) {
  for (const double number :
       {-0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::denorm_min(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(unpacked<double>(packed(number))),
              std::bit_cast<std::uint64_t>(number));
  }
}

TEST(Packed, RefusesBytesThatEndTooEarlyOrTooLate) {
  const std::string bytes = packed(std::vector<std::string>{"ice", "berg"});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW((void)unpacked<std::vector<std::string>>(bytes.substr(0, size)), std::runtime_error) << size;
  EXPECT_THROW((void)unpacked<std::vector<std::string>>(bytes + '\0'), std::runtime_error);
  EXPECT_THROW((void)unpacked<std::string>(std::string(8, '\xff')), std::runtime_error);
}

TEST(Packed, RefusesAVariantOfAnotherKind) {
  using Value = std::variant<double, std::string>;
  std::string bytes = packed(Value{1.5});
  bytes[0] = 2;
  EXPECT_THROW((void)unpacked<Value>(bytes), std::runtime_error);
}

}  // namespace
}  // namespace floeplan::core::packed_test
