#include "engine/core/utf8_text.hpp"

#include <cstddef>
#include <cstdint>

namespace floeplan::core {
namespace {

constexpr std::uint32_t replacement = 0xFFFD;

std::uint8_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

/// Number of bytes of the sequence that begins with `first`; 0 if no sequence does.
std::size_t sequence_length(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// Whether `second` is valid after `first` in a sequence of three or four bytes. Others are overlong,
/// surrogates or too large.
bool may_follow(std::uint8_t first, std::uint8_t second) {
  switch (first) {
    case 0xE0: return second >= 0xA0;
    case 0xED: return second < 0xA0;
    case 0xF0: return second >= 0x90;
    case 0xF4: return second < 0x90;
    default: return true;
  }
}

void append(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto add_rest = [&](int shift) {
    for (; shift >= 0; shift -= 6) add(0x80 | ((code >> shift) & 0x3F));
  };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | (code >> 6));
    add_rest(0);
  } else if (code < 0x10000) {
    add(0xE0 | (code >> 12));
    add_rest(6);
  } else {
    add(0xF0 | (code >> 18));
    add_rest(12);
  }
}

std::string from_utf16(std::string_view bytes, bool is_little_endian) {
  const auto unit_at = [&](std::size_t at) {
    const std::uint32_t first = byte_at(bytes, at);
    const std::uint32_t second = byte_at(bytes, at + 1);
    return is_little_endian ? first | (second << 8) : (first << 8) | second;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  std::size_t at = 0;
  for (; at + 1 < bytes.size(); at += 2) {
    const std::uint32_t unit = unit_at(at);
    const bool is_high = unit >= 0xD800 && unit < 0xDC00;
    const std::uint32_t next = is_high && at + 3 < bytes.size() ? unit_at(at + 2) : 0;
    if (next >= 0xDC00 && next < 0xE000) {
      append(text, 0x10000 + ((unit - 0xD800) << 10) + (next - 0xDC00));
      at += 2;
    } else {
      append(text, unit >= 0xD800 && unit < 0xE000 ? replacement : unit);
    }
  }
  if (at < bytes.size()) append(text, replacement);
  return text;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::uint8_t first = byte_at(bytes, at);
    const std::size_t length = sequence_length(first);
    if (length == 0 || at + length > bytes.size()) return false;
    for (std::size_t i = 1; i < length; ++i)
      if ((byte_at(bytes, at + i) & 0xC0) != 0x80) return false;
    if (length > 2 && !may_follow(first, byte_at(bytes, at + 1))) return false;
    at += length;
  }
  return true;
}

std::string utf8_text(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return std::string{bytes.substr(3)};
  if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes.substr(2), true);
  if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes.substr(2), false);
  const bool is_long = bytes.size() >= 4;
  const auto is_ascii = [&](std::size_t at) { return bytes[at] != '\0' && byte_at(bytes, at) < 0x80; };
  if (is_long && is_ascii(0) && bytes[1] == '\0' && is_ascii(2) && bytes[3] == '\0')
    return from_utf16(bytes, true);
  if (is_long && bytes[0] == '\0' && is_ascii(1) && bytes[2] == '\0' && is_ascii(3))
    return from_utf16(bytes, false);
  return std::string{bytes};
}

}  // namespace floeplan::core
