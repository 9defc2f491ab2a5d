#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace floeplan::mission {

/// Text formatted by `std::printf` rules, at most 299 bytes.
template <class... Values>
[[nodiscard]] std::string print(const char* format, Values... values) {
  std::array<char, 300> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace floeplan::mission
