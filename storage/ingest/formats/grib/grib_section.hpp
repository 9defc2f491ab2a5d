#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "engine/messages/ingest_grib_messages.hpp"

namespace floeplan::ingest {

/// Thrown when a GRIB2 file cannot be read, with the message of its refusal. The readers' public functions
/// catch it.
struct BadGrib {
  messages::Message reason;
};

[[noreturn]] inline void fail_grib(messages::Message reason) { throw BadGrib{std::move(reason)}; }

[[noreturn]] inline void fail_cut_grib() { fail_grib(messages::ingest_grib_message<"grib-cut-short">()); }

/// Reads numbers from a section of a GRIB2 message; octets are counted from 1, as in the manual.
/// Errors  BadGrib for octets beyond its end
class GribSection {
 public:
  explicit GribSection(std::string octets) : octets_{std::move(octets)} {}

  [[nodiscard]] std::uint64_t at(std::size_t first, std::size_t count) const {
    if (first + count - 1 > octets_.size()) fail_cut_grib();
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
      value = value << 8U | static_cast<unsigned char>(octets_[first - 1 + i]);
    return value;
  }
  /// A signed number: its first bit is the sign, the others the magnitude.
  [[nodiscard]] std::int64_t signed_at(std::size_t first, std::size_t count) const {
    const std::uint64_t value = at(first, count);
    const std::uint64_t sign = std::uint64_t{1} << (8 * count - 1);
    const auto size = static_cast<std::int64_t>(value & ~sign);
    return (value & sign) != 0 ? -size : size;
  }
  /// Whether all bits of a number are set, which marks a missing value.
  [[nodiscard]] bool is_missing(std::size_t first, std::size_t count) const {
    return at(first, count) == (count == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * count)) - 1);
  }
  [[nodiscard]] const std::string& octets() const { return octets_; }

 private:
  std::string octets_;
};

}  // namespace floeplan::ingest
