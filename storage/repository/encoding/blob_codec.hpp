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

/// Arrays of numbers as compressed blobs and back, every bit kept (NaN payloads and signed zeros too).
/// Format   little-endian, shuffled (all first bytes, then all second bytes, ...), one zstd frame with a
///          checksum. Neighbouring values of a smooth field share their high bytes; shuffling joins those. Floats that
///          are multiples of steps: those (see write_as_steps), told by their odd length, in the same frame
/// Threads  one thread at a time
/// Errors   sql::Failure (damaged) from `unpack` and `check` for a damaged blob or one of another length
class BlobCodec {
 public:
  BlobCodec();
  BlobCodec(const BlobCodec&) = delete;
  BlobCodec& operator=(const BlobCodec&) = delete;
  ~BlobCodec();

  /// All return views of scratch memory, valid until the next call.
  [[nodiscard]] std::span<const std::byte> pack(std::span<const float> values);
  [[nodiscard]] std::span<const std::byte> pack(std::span<const double> values);
  [[nodiscard]] std::span<const std::byte> pack(std::span<const std::uint32_t> values);

  /// Packs the samples as whole numbers of steps, if every sample is one.
  [[nodiscard]] std::span<const std::byte> pack(std::span<const float> values, const SampleSteps& steps);

  /// A view of scratch memory, valid until the next call: fields are read by the thousand of such blobs.
  [[nodiscard]] std::span<const float> unpack_floats(std::span<const std::byte> blob, std::size_t count);
  [[nodiscard]] std::vector<double> unpack_doubles(std::span<const std::byte> blob, std::size_t count);
  [[nodiscard]] std::vector<std::uint32_t> unpack_numbers(std::span<const std::byte> blob, std::size_t count);

  /// Compares a blob with its checksum.
  void check(std::span<const std::byte> blob);

  /// How many bytes the blob holds once unpacked.
  [[nodiscard]] static std::size_t unpacked_bytes(std::span<const std::byte> blob);

 private:
  struct Release {
    void operator()(ZSTD_CCtx_s* context) const;
    void operator()(ZSTD_DCtx_s* context) const;
  };

  template <class T, class Bits>
  std::span<const std::byte> pack_as(std::span<const T> values);
  std::span<const std::byte> compress();
  /// The bytes as they were before they were compressed, still shuffled.
  std::span<const std::byte> decompress(std::span<const std::byte> blob, std::size_t bytes);

  std::unique_ptr<ZSTD_CCtx_s, Release> compressor_;
  std::unique_ptr<ZSTD_DCtx_s, Release> decompressor_;
  std::vector<std::byte> shuffled_;
  std::vector<std::byte> packed_;
  std::vector<float> floats_;
};

}  // namespace floeplan::repository
