#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "storage/repository/encoding/sample_steps.hpp"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace floeplan::repository {

/// Packs arrays of numbers into compressed blobs and unpacks them. Every bit is kept, also of NaN payloads
/// and signed zeros.
/// Format   little-endian, shuffled (all first bytes, then all second bytes, ...), one zstd frame with a
///          checksum. Shuffling brings together the high bytes, which are similar for neighbouring values of
///          a smooth field. Floats that are multiples of a step are stored as counts instead (see
///          write_as_steps); their odd length shows this
/// Threads  one thread at a time
/// Errors   sql::Failure (damaged) from `unpack` and `check` for a damaged blob or one of another length
class BlobCodec {
 public:
  BlobCodec();
  BlobCodec(const BlobCodec&) = delete;
  BlobCodec& operator=(const BlobCodec&) = delete;
  ~BlobCodec();

  /// All overloads return a view of scratch memory, which is valid until the next call of `pack`.
  [[nodiscard]] std::span<const std::byte> pack(std::span<const float> values);
  [[nodiscard]] std::span<const std::byte> pack(std::span<const double> values);
  [[nodiscard]] std::span<const std::byte> pack(std::span<const std::uint32_t> values);

  /// Packs the samples as counts of steps if every sample is a multiple of the step; otherwise as floats.
  [[nodiscard]] std::span<const std::byte> pack(std::span<const float> values, const SampleSteps& steps);

  /// Unpacks floats. Returns a view of scratch memory, which is valid until the next call of `unpack_floats`.
  /// Not a copy, because fields consist of thousands of such blobs.
  [[nodiscard]] std::span<const float> unpack_floats(std::span<const std::byte> blob, std::size_t count);
  [[nodiscard]] std::vector<double> unpack_doubles(std::span<const std::byte> blob, std::size_t count);
  [[nodiscard]] std::vector<std::uint32_t> unpack_numbers(std::span<const std::byte> blob, std::size_t count);

  /// Verifies the checksum of a blob.
  void check(std::span<const std::byte> blob);

  /// Size of the blob's content after unpacking, bytes.
  [[nodiscard]] static std::size_t unpacked_bytes(std::span<const std::byte> blob);

 private:
  struct Release {
    void operator()(ZSTD_CCtx_s* context) const;
    void operator()(ZSTD_DCtx_s* context) const;
  };

  template <class T, class Bits>
  std::span<const std::byte> pack_as(std::span<const T> values);
  std::span<const std::byte> compress();
  /// The decompressed bytes, still shuffled.
  std::span<const std::byte> decompress(std::span<const std::byte> blob, std::size_t bytes);

  std::unique_ptr<ZSTD_CCtx_s, Release> compressor_;
  std::unique_ptr<ZSTD_DCtx_s, Release> decompressor_;
  std::vector<std::byte> shuffled_;
  std::vector<std::byte> packed_;
  std::vector<float> floats_;
};

}  // namespace floeplan::repository
