#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace floeplan::repository {

/// The first ten names and how many more there are.
[[nodiscard]] inline std::string shortened_list(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

}  // namespace floeplan::repository
