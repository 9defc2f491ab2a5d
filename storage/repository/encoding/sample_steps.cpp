#include "storage/repository/encoding/sample_steps.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace floeplan::repository {
namespace {

constexpr std::byte format{1};
constexpr std::size_t header_bytes = 1 + 2 * sizeof(double);
constexpr std::uint32_t missing_code = 65'535;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
constexpr double largest_count = 1e9;

float sample_of(std::int32_t count, const SampleSteps& steps) {
  return static_cast<float>(steps.offset + steps.step * static_cast<double>(count));
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

std::size_t bytes_as_steps(std::size_t samples) { return header_bytes + 2 * samples; }

bool write_as_steps(std::span<const float> samples, const SampleSteps& steps, std::vector<std::byte>& out) {
  out.resize(bytes_as_steps(samples.size()));
  out[0] = format;
  std::memcpy(out.data() + 1, &steps.step, sizeof(double));
  std::memcpy(out.data() + 1 + sizeof(double), &steps.offset, sizeof(double));
  std::byte* const low = out.data() + header_bytes;
  std::byte* const high = low + samples.size();

  const double steps_per_unit =
      1.0 / steps.step;  // a division per sample would take a third of the whole time
  std::int32_t last = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::uint32_t code = missing_code;
    if (!same_bits(samples[i], no_number)) {
      const double exact = (static_cast<double>(samples[i]) - steps.offset) * steps_per_unit;
      if (!(std::abs(exact) < largest_count)) return false;
      const auto count = static_cast<std::int32_t>(exact + (exact < 0.0 ? -0.5 : 0.5));
      if (!same_bits(sample_of(count, steps), samples[i])) return false;
      const std::int32_t difference = count - last;
      code = (static_cast<std::uint32_t>(difference) << 1) ^ static_cast<std::uint32_t>(difference >> 31);
      if (code >= missing_code) return false;
      last = count;
    }
    low[i] = static_cast<std::byte>(code & 0xff);
    high[i] = static_cast<std::byte>(code >> 8);
  }
  return true;
}

bool read_steps(std::span<const std::byte> bytes, std::span<float> out) {
  if (bytes.size() != bytes_as_steps(out.size()) || bytes[0] != format) return false;
  SampleSteps steps;
  std::memcpy(&steps.step, bytes.data() + 1, sizeof(double));
  std::memcpy(&steps.offset, bytes.data() + 1 + sizeof(double), sizeof(double));
  const std::byte* const low = bytes.data() + header_bytes;
  const std::byte* const high = low + out.size();

  std::uint32_t count = 0;  // in two's complement
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto code = std::to_integer<std::uint32_t>(low[i]) | (std::to_integer<std::uint32_t>(high[i]) << 8);
    if (code == missing_code) {
      out[i] = no_number;
      continue;
    }
    count += (code >> 1) ^ (0U - (code & 1));
    out[i] = sample_of(static_cast<std::int32_t>(count), steps);
  }
  return true;
}

}  // namespace floeplan::repository
