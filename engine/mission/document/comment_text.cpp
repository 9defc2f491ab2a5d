#include "engine/mission/document/comment_text.hpp"

namespace floeplan::mission {

std::string comment_text(std::string_view text, std::size_t max_length) {
  std::string kept;
  for (const char c : text) {
    if (kept.size() == max_length) break;
    if (c < ' ' || c > '~') continue;
    if (c == ' ' && (kept.empty() || kept.back() == ' ')) continue;
    kept += c;
  }
  if (kept.ends_with(' ')) kept.pop_back();
  return kept;
}

}  // namespace floeplan::mission
