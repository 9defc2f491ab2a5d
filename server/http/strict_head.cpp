#include "server/http/strict_head.hpp"

#include <algorithm>
#include <string>

#include "engine/core/letter_case.hpp"

namespace floeplan::http {
namespace {

constexpr std::string_view line_end = "\r\n";
constexpr std::string_view head_end = "\r\n\r\n";

bool is_control(char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f'; }

/// Whether a character is allowed in a token (RFC 9110, 5.6.2).
bool is_token_character(char c) {
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         marks.find(c) != std::string_view::npos;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Whether a text is a length: at most 18 digits, enough for any number of bytes and without overflow.
bool is_length(std::string_view text) {
  constexpr std::size_t most_digits = 18;
  return !text.empty() && text.size() <= most_digits &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The headers that determine the end of a request.
struct Framing {
  int lengths{0};
  int codings{0};
  bool plain{true};  // their values are of the only form that all servers parse equally
};

/// Reads a header line; false if it is not one.
bool read_field(std::string_view line, Framing& framing) {
  const auto colon = line.find(':');
  if (colon == 0 || colon == std::string_view::npos) return false;
  const std::string_view name = line.substr(0, colon);
  if (!std::all_of(name.begin(), name.end(), is_token_character)) return false;
  const std::string_view value = without_blanks(line.substr(colon + 1));
  const std::string plain_name = core::lower_case(name);
  if (plain_name == "content-length") {
    ++framing.lengths;
    framing.plain = framing.plain && is_length(value);
  } else if (plain_name == "transfer-encoding") {
    ++framing.codings;
    framing.plain = framing.plain && core::lower_case(value) == "chunked";
  }
  return true;
}

/// `head`  the header without the empty line at its end
bool is_strict(std::string_view head) {
  if (std::any_of(head.begin(), head.end(), [](char c) { return is_control(c) && c != '\r' && c != '\n'; }))
    return false;
  auto end = std::min(head.find(line_end), head.size());
  const std::string_view request_line = head.substr(0, end);
  const bool is_newest = request_line.ends_with(" HTTP/1.1");
  if (!is_newest && !request_line.ends_with(" HTTP/1.0")) return false;
  if (request_line.find('\t') != std::string_view::npos) return false;
  Framing framing;
  while (end < head.size()) {
    head.remove_prefix(end + line_end.size());
    end = std::min(head.find(line_end), head.size());
    if (!read_field(head.substr(0, end), framing)) return false;
  }
  return framing.plain && framing.lengths + framing.codings <= 1 && (framing.codings == 0 || is_newest);
}

}  // namespace

StrictHead::State StrictHead::look_at(std::string_view bytes) {
  for (; looked_at_ < bytes.size(); ++looked_at_) {
    const bool is_end = bytes[looked_at_] == '\n';
    if (is_end && (looked_at_ == 0 || bytes[looked_at_ - 1] != '\r')) return State::faulty;
    if (!is_end && looked_at_ > 0 && bytes[looked_at_ - 1] == '\r') return State::faulty;
    const std::string_view so_far = bytes.substr(0, looked_at_ + 1);
    if (is_end && so_far.ends_with(head_end))
      return is_strict(so_far.substr(0, so_far.size() - head_end.size())) ? State::complete : State::faulty;
  }
  return State::incomplete;
}

}  // namespace floeplan::http
