#include "engine/core/letter_case.hpp"

#include <algorithm>

namespace floeplan::core {

std::string lower_case(std::string_view text) {
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::string plain_word(std::string_view text) {
  std::string result = lower_case(text);
  std::erase_if(result, [](char c) { return !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9'); });
  return result;
}

}  // namespace floeplan::core
