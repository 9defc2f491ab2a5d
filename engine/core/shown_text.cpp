#include "engine/core/shown_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "engine/core/letter_case.hpp"

namespace floeplan::core {
namespace {

constexpr std::string_view hidden = "(hidden)";

bool is_digit_of_secret(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool ends_a_word(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '"' || c == ';' || c == ',' || c == '&';
}

/// The text before a secret, and the characters that the secret itself consists of.
struct SecretShape {
  std::string_view begin;  // in lower case
  bool (*belongs)(char);
  std::size_t least;  // least length of a secret; shorter text is not hidden
};

constexpr std::array<SecretShape, 3> shapes{{{"floeplan_session=", [](char c) { return !ends_a_word(c); }, 1},
                                             {"floeplan_", is_digit_of_secret, 8},
                                             {"bearer ", [](char c) { return !ends_a_word(c); }, 8}}};

int value_of(char digit) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto found = digits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(digit))));
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

std::string decoded_once(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code =
        text[i] == '%' && i + 2 < text.size() && value_of(text[i + 1]) >= 0 && value_of(text[i + 2]) >= 0;
    if (is_code) {
      result += static_cast<char>(16 * value_of(text[i + 1]) + value_of(text[i + 2]));
      i += 2;
    } else {
      result += text[i] == '+' ? ' ' : text[i];
    }
  }
  return result;
}

/// Percent-decodes the text repeatedly, at most five times. So a secret cannot hide in a text that was encoded
/// several times.
std::string decoded(std::string_view text) {
  constexpr int most_layers = 5;
  std::string result{text};
  for (int i = 0; i < most_layers && result.find('%') != std::string::npos; ++i)
    result = decoded_once(result);
  return result;
}

bool holds_secret(std::string_view text) {
  const std::string plain = decoded(text);
  return without_secrets(plain) != plain;
}

bool speaks_of_secrets(std::string_view name) {
  constexpr std::array<std::string_view, 12> words{"token", "secret", "passw", "pwd",  "auth",      "key",
                                                   "sess",  "cookie", "cred",  "sign", "signature", "jwt"};
  const std::string plain = lower_case(decoded(name));
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

std::string shown_pair(std::string_view pair) {
  const auto equals = pair.find('=');
  const std::string_view name = pair.substr(0, equals);
  if (holds_secret(name)) return std::string{hidden};
  if (equals == std::string_view::npos) return std::string{pair};
  if (speaks_of_secrets(name) || holds_secret(pair)) return std::string{name} + "=" + std::string{hidden};
  return std::string{pair};
}

}  // namespace

std::string without_secrets(std::string_view text) {
  const std::string plain = lower_case(text);
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const SecretShape& candidate) {
      return plain.compare(i, candidate.begin.size(), candidate.begin) == 0;
    });
    if (shape == shapes.end()) {
      result += text[i++];
      continue;
    }
    const std::size_t begin = i + shape->begin.size();
    std::size_t end = begin;
    while (end < text.size() && shape->belongs(text[end])) ++end;
    result += text.substr(i, shape->begin.size());
    if (end - begin >= shape->least) {
      result += hidden;
    } else {
      result += text.substr(begin, end - begin);
    }
    i = end;
  }
  return result;
}

std::string shown_target(std::string_view target, std::size_t most) {
  const auto question = target.find('?');
  const std::string_view path = target.substr(0, question);
  std::string result = holds_secret(path) ? without_secrets(decoded(path)) : std::string{path};
  if (question != std::string_view::npos) {
    char before = '?';
    for (std::string_view rest = target.substr(question + 1); !rest.empty() && result.size() < most;
         before = '&') {
      const auto end = std::min(rest.find('&'), rest.size());
      result += before + shown_pair(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return result.substr(0, most);
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest_word = 100;
  constexpr std::size_t kept_of_word = 60;
  constexpr std::size_t longest_text = 2000;
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", i), text.size());
    std::string_view word = text.substr(i, end - i);
    if (word.size() > longest_word) {
      std::size_t kept = kept_of_word;
      while (kept > 0 && (static_cast<unsigned char>(word[kept]) & 0xC0U) == 0x80U)
        --kept;  // never cut inside a UTF-8 character
      result += std::string{word.substr(0, kept)} + "... (" + std::to_string(word.size()) + " characters)";
    } else {
      result += word;
    }
    if (end < text.size()) result += text[end];
    i = end + 1;
    if (result.size() > longest_text) return result + "...";
  }
  return result;
}

std::string shortened_list(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

std::string distance_text(Metres distance) {
  const bool is_short = std::round(distance.value) < 1000.0;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(),
                is_short ? "%.0f m" : (distance.value < 1e5 ? "%.1f km" : "%.0f km"),
                is_short ? distance.value : distance.value / 1000.0);
  return text.data();
}

std::string counted(std::size_t count, std::string_view thing) {
  return std::to_string(count) + ' ' + std::string{thing} + (count == 1 ? "" : "s");
}

}  // namespace floeplan::core
