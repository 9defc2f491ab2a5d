#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace floeplan::repository {

/// Steps of values that a file stores as whole numbers: value = offset + step * count. By default whole
/// numbers.
struct SampleSteps {
  double step{1.0};
  double offset{0.0};
};

/// Writes samples as counts of steps, if every bit of every sample can be restored. Takes a third of the size
/// of floats.
/// Format   little-endian: a format byte, step, offset; then 16 bits for the difference of each count to the
///          one before: differences 0, -1, 1, -2, ... are coded as 0, 1, 2, 3, ..., and NaN as 65535; first
///          all low bytes, then all high bytes. The length is always odd
/// Returns  false if a sample is not a multiple of the step, or a difference is too large; `out` is then
///          invalid
[[nodiscard]] bool write_as_steps(std::span<const float> samples, const SampleSteps& steps,
                                  std::vector<std::byte>& out);

/// Length in bytes of this number of samples in the format of write_as_steps.
[[nodiscard]] std::size_t bytes_as_steps(std::size_t samples);

/// Reads what write_as_steps wrote. `bytes` must have the length that bytes_as_steps gives for the size of
/// `out`.
/// Returns  false for another format
[[nodiscard]] bool read_steps(std::span<const std::byte> bytes, std::span<float> out);

}  // namespace floeplan::repository
