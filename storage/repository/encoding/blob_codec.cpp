#include "storage/repository/encoding/blob_codec.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::repository {
namespace {

constexpr int compression_level = 3;
constexpr std::size_t largest_blob_bytes = std::size_t{1} << 30;

[[noreturn]] void refuse(const std::string& why) {
  throw sql::Failure{messages::store_text<"stored-data-damaged">(why), sql::Trouble::damaged};
}

/// Joins the bytes of each number.
/// `planes`  all first bytes, then all second bytes, ...
template <class T, class Bits>
void unshuffle(std::span<const std::byte> planes, std::span<T> values) {
  // The compiler vectorises blocks of a fixed length: four times as fast as number by number.
  constexpr std::size_t block = 16;
  const std::size_t count = values.size();
  std::array<Bits, block> numbers{};
  for (std::size_t begin = 0; begin < count; begin += block) {
    const std::size_t length = std::min(block, count - begin);
    numbers.fill(0);
    for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
      const std::byte* const bytes = planes.data() + plane * count + begin;
      const auto join = [&](std::size_t i) { numbers[i] |= static_cast<Bits>(bytes[i]) << (8 * plane); };
      if (length == block) {
        for (std::size_t i = 0; i < block; ++i) join(i);
      } else {
        for (std::size_t i = 0; i < length; ++i) join(i);
      }
    }
    std::memcpy(values.data() + begin, numbers.data(), length * sizeof(T));
  }
}

}  // namespace

void BlobCodec::Release::operator()(ZSTD_CCtx_s* context) const { ZSTD_freeCCtx(context); }
void BlobCodec::Release::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

BlobCodec::BlobCodec() : compressor_{ZSTD_createCCtx()}, decompressor_{ZSTD_createDCtx()} {
  if (!compressor_ || !decompressor_) throw std::bad_alloc{};
  ZSTD_CCtx_setParameter(compressor_.get(), ZSTD_c_compressionLevel, compression_level);
  ZSTD_CCtx_setParameter(compressor_.get(), ZSTD_c_checksumFlag, 1);
}

BlobCodec::~BlobCodec() = default;

std::span<const std::byte> BlobCodec::pack(std::span<const float> values) {
  return pack_as<float, std::uint32_t>(values);
}

std::span<const std::byte> BlobCodec::pack(std::span<const double> values) {
  return pack_as<double, std::uint64_t>(values);
}

std::span<const std::byte> BlobCodec::pack(std::span<const std::uint32_t> values) {
  return pack_as<std::uint32_t, std::uint32_t>(values);
}

std::span<const std::byte> BlobCodec::pack(std::span<const float> values, const SampleSteps& steps) {
  return write_as_steps(values, steps, shuffled_) ? compress() : pack(values);
}

std::span<const float> BlobCodec::unpack_floats(std::span<const std::byte> blob, std::size_t count) {
  floats_.resize(count);
  if (unpacked_bytes(blob) == bytes_as_steps(count)) {
    if (!read_steps(decompress(blob, bytes_as_steps(count)), floats_)) refuse("a block of unknown form");
    return floats_;
  }
  unshuffle<float, std::uint32_t>(decompress(blob, count * sizeof(float)), floats_);
  return floats_;
}

std::vector<double> BlobCodec::unpack_doubles(std::span<const std::byte> blob, std::size_t count) {
  std::vector<double> values(count);
  unshuffle<double, std::uint64_t>(decompress(blob, count * sizeof(double)), values);
  return values;
}

std::vector<std::uint32_t> BlobCodec::unpack_numbers(std::span<const std::byte> blob, std::size_t count) {
  std::vector<std::uint32_t> values(count);
  unshuffle<std::uint32_t, std::uint32_t>(decompress(blob, count * sizeof(std::uint32_t)), values);
  return values;
}

void BlobCodec::check(std::span<const std::byte> blob) { (void)decompress(blob, unpacked_bytes(blob)); }

std::size_t BlobCodec::unpacked_bytes(std::span<const std::byte> blob) {
  const auto bytes = ZSTD_getFrameContentSize(blob.data(), blob.size());
  // error values of the library are larger, too
  if (bytes > largest_blob_bytes) refuse("not a compressed block");
  return bytes;
}

template <class T, class Bits>
std::span<const std::byte> BlobCodec::pack_as(std::span<const T> values) {
  const std::size_t count = values.size();
  shuffled_.resize(count * sizeof(T));
  for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
    std::byte* const out = shuffled_.data() + plane * count;
    for (std::size_t i = 0; i < count; ++i) {
      out[i] = static_cast<std::byte>(std::bit_cast<Bits>(values[i]) >> (8 * plane));
    }
  }
  return compress();
}

std::span<const std::byte> BlobCodec::compress() {
  packed_.resize(ZSTD_compressBound(shuffled_.size()));
  const std::size_t size =
      ZSTD_compress2(compressor_.get(), packed_.data(), packed_.size(), shuffled_.data(), shuffled_.size());
  if (ZSTD_isError(size) != 0)
    throw std::runtime_error{std::string{"cannot compress: "} + ZSTD_getErrorName(size)};
  return std::span{packed_}.first(size);
}

std::span<const std::byte> BlobCodec::decompress(std::span<const std::byte> blob, std::size_t bytes) {
  if (unpacked_bytes(blob) != bytes) refuse("a block of another size than its grid says");
  shuffled_.resize(bytes);
  const std::size_t size =
      ZSTD_decompressDCtx(decompressor_.get(), shuffled_.data(), shuffled_.size(), blob.data(), blob.size());
  if (ZSTD_isError(size) != 0) refuse(ZSTD_getErrorName(size));
  if (size != shuffled_.size()) refuse("a block that ends early");
  return shuffled_;
}

}  // namespace floeplan::repository
