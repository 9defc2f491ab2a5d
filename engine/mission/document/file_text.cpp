#include "engine/mission/document/file_text.hpp"

#include <algorithm>
#include <cstdint>

#include "engine/messages/mission_file_messages.hpp"

namespace floeplan::mission {
namespace {

constexpr std::string_view utf8_byte_order_mark = "\xEF\xBB\xBF";
constexpr char dos_end_of_file = '\x1A';

bool is_ascii(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// Length in bytes of the well-formed UTF-8 sequence at the start of `bytes`; 0 if there is none.
/// Source   The Unicode Standard 15.0, table 3-7
std::size_t utf8_sequence(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                             : lead >= 0xE0 && lead <= 0xEF ? 3
                             : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                            : 0;
  if (length == 0 || bytes.size() < length) return 0;
  std::uint8_t from = 0x80;
  std::uint8_t to = 0xBF;
  if (lead == 0xE0) from = 0xA0;
  if (lead == 0xED) to = 0x9F;
  if (lead == 0xF0) from = 0x90;
  if (lead == 0xF4) to = 0x8F;
  if (byte(1) < from || byte(1) > to) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  return length;
}

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = utf8_sequence(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto code = static_cast<std::uint8_t>(c);
    if (code < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | (code >> 6));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

/// The text without the control-Z characters at its end, which may be mixed with line ends.
std::string_view without_end_of_file(std::string_view bytes) {
  const std::size_t last = bytes.find_last_not_of("\x1A\r\n");
  const std::size_t mark = bytes.find(dos_end_of_file, last == std::string_view::npos ? 0 : last);
  return bytes.substr(0, mark);
}

/// Splits at every kind of line end, and records the kinds found.
void split_lines(std::string_view text, FileText& file) {
  bool lf = false;
  bool crlf = false;
  bool cr = false;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find_first_of("\r\n", begin);
    file.lines.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) break;
    const bool pair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    (pair ? crlf : text[end] == '\n' ? lf : cr) = true;
    begin = end + (pair ? 2 : 1);
  }
  file.format.ends_with_newline = !text.empty() && (text.back() == '\n' || text.back() == '\r');
  file.format.line_endings = cr && (lf || crlf) ? "mixed"
                             : cr               ? "CR"
                             : lf && crlf       ? "CRLF+LF"
                             : crlf             ? "CRLF"
                             : lf               ? "LF"
                                                : "none";
}

}  // namespace

tl::expected<FileText, Message> decode_file(std::string_view bytes) {
  if (bytes.size() > max_file_bytes) {
    return tl::unexpected(finding(0, messages::mission_file_message<"file_too_large">()));
  }
  if (const auto nul = bytes.find('\0'); nul != std::string_view::npos) {
    const auto line = 1 + std::ranges::count(bytes.substr(0, nul), '\n');
    return tl::unexpected(
        finding(static_cast<int>(line), is_utf16(bytes) ? messages::mission_file_message<"binary_file/wide">()
                                                        : messages::mission_file_message<"binary_file">()));
  }
  FileText file;
  file.format.bytes = bytes.size();
  file.byte_order_mark = bytes.starts_with(utf8_byte_order_mark);
  if (file.byte_order_mark) bytes.remove_prefix(utf8_byte_order_mark.size());
  bytes = without_end_of_file(bytes);

  const bool ascii = is_ascii(bytes);
  const bool utf8 = ascii || is_utf8(bytes);
  file.format.encoding = ascii ? "ascii" : utf8 ? "utf-8" : "iso-8859-1";
  split_lines(utf8 ? std::string{bytes} : from_latin1(bytes), file);
  return file;
}

}  // namespace floeplan::mission
