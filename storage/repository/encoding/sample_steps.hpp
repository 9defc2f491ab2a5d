#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace floeplan::repository {

/// Numbers that a file holds as whole multiples: value = offset + step * count. The default: whole numbers.
struct SampleSteps {
  double step{1.0};
  double offset{0.0};
};

/// Writes samples as counts of steps, where that gives every bit of every sample back; a third of their size as floats.
/// Format   little-endian: a format byte, step, offset; from each count to the next 16 bits, 0, -1, 1, -2, ... as
///          0, 1, 2, 3, ..., and 65535 for NaN, first all low bytes, then all high bytes. Its length is always odd
/// Returns  false when a sample is no whole number of steps, or the next one too far off; `out` is then of no use
[[nodiscard]] bool write_as_steps(std::span<const float> samples, const SampleSteps& steps,
                                  std::vector<std::byte>& out);

/// How long as many samples are as steps.
[[nodiscard]] std::size_t bytes_as_steps(std::size_t samples);

/// Reads what write_as_steps wrote; `bytes` are as long as bytes_as_steps says of `out`.
/// Returns  false for another format
[[nodiscard]] bool read_steps(std::span<const std::byte> bytes, std::span<float> out);

}  // namespace floeplan::repository
