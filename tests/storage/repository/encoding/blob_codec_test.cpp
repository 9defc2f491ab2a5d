#include "storage/repository/encoding/blob_codec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::repository::blob_codec_test {
namespace {

TEST(BlobCodec, KeepsEveryBit) {
  BlobCodec codec;
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    std::vector<float> values(static_cast<std::size_t>(support::uniform_int(rng, 0, 5000)));
    for (float& value : values) value = std::bit_cast<float>(static_cast<std::uint32_t>(rng()));

    const auto blob = codec.pack(std::span<const float>{values});
    const std::vector<std::byte> stored{blob.begin(), blob.end()};
    const std::span<const float> read = codec.unpack_floats(stored, values.size());

    ASSERT_EQ(read.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(read[i]), std::bit_cast<std::uint32_t>(values[i]));
    }
  });
}

TEST(BlobCodec, KeepsEveryBitOfDoubles) {
  BlobCodec codec;
  const std::vector<double> values{0.1, -0.0, 1e308, 5e-324};
  const auto blob = codec.pack(std::span<const double>{values});
  const std::vector<std::byte> stored{blob.begin(), blob.end()};

  EXPECT_EQ(BlobCodec::unpacked_bytes(stored), 32U);
  EXPECT_EQ(codec.unpack_doubles(stored, 4), values);
}

TEST(BlobCodec, KeepsEveryBitOfSamplesThatAreCountsOfSteps) {
  BlobCodec codec;
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    const SampleSteps steps{support::uniform(rng, 1e-5, 1e-2), support::uniform(rng, -20.0, 20.0)};
    std::vector<float> values(static_cast<std::size_t>(support::uniform_int(rng, 500, 5000)));
    int count = support::uniform_int(rng, -32'767, 32'767);
    for (float& value : values) {
      count = std::clamp(count + support::uniform_int(rng, -20, 20), -32'767, 32'767);
      value = support::uniform_int(rng, 0, 9) == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                   : static_cast<float>(steps.step * count + steps.offset);
    }

    const auto blob = codec.pack(values, steps);
    const std::vector<std::byte> stored{blob.begin(), blob.end()};
    const std::span<const float> read = codec.unpack_floats(stored, values.size());

    EXPECT_LT(stored.size(), 3 * values.size() / 2);
    ASSERT_EQ(read.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(read[i]), std::bit_cast<std::uint32_t>(values[i]));
    }
  });
}

TEST(BlobCodec, KeepsEveryBitOfSamplesThatAreNoCountsOfSteps) {
  BlobCodec codec;
  for (const float odd : {0.0005F, -0.0F, 1e30F, 70.0F, std::bit_cast<float>(0x7fc00001U)}) {
    const std::vector<float> values{0.001F, 0.002F, odd, 0.001F};

    const auto blob = codec.pack(values, {.step = 0.001, .offset = 0.0});
    const std::vector<std::byte> stored{blob.begin(), blob.end()};
    const std::span<const float> read = codec.unpack_floats(stored, values.size());

    EXPECT_EQ(BlobCodec::unpacked_bytes(stored), 16U) << odd;
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(read[i]), std::bit_cast<std::uint32_t>(values[i]));
    }
  }
}

TEST(BlobCodec, RefusesABlobOfAnotherLengthAndADamagedOne) {
  BlobCodec codec;
  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    std::vector<float> values(1000);
    for (float& value : values) value = static_cast<float>(support::uniform(rng, -1.0, 1.0));
    const auto blob = codec.pack(std::span<const float>{values});
    std::vector<std::byte> stored{blob.begin(), blob.end()};
    EXPECT_THROW((void)codec.unpack_floats(stored, 999), std::runtime_error);

    stored[rng() % stored.size()] ^= std::byte{0x10};
    try {
      // A few bits of the frame's header carry no meaning; then the values must be right.
      EXPECT_TRUE(std::ranges::equal(codec.unpack_floats(stored, 1000), values));
    } catch (const std::runtime_error&) {
      SUCCEED();
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::blob_codec_test
