#include "engine/core/near_word.hpp"

#include <algorithm>
#include <cstddef>

namespace floeplan::core {
namespace {

/// Number of letters to change, insert, remove or swap with the next (optimal string alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) table[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      table[i][j] = std::min({changed, table[i - 1][j] + 1, table[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
    }
  }
  return table[a.size()][b.size()];
}

}  // namespace

std::string near_word(std::string_view written, const std::vector<std::string>& words) {
  const std::size_t most = std::max<std::size_t>(1, written.size() / 3);
  std::string best;
  std::size_t least = most + 1;
  for (const std::string& word : words) {
    if (const std::size_t wrong = distance(written, word); wrong < least) {
      least = wrong;
      best = word;
    }
  }
  return best;
}

}  // namespace floeplan::core
