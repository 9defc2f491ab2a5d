#include "engine/core/violation_list.hpp"

#include <cassert>
#include <string_view>
#include <utility>

namespace floeplan::core {
namespace {

constexpr std::size_t longest_field = 200;
constexpr std::size_t longest_rule = 1000;
constexpr std::string_view ellipsis = "...";

/// Whether the byte continues a UTF-8 character, that is, is not its first byte.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

void note(Violations& list, Violation violation) {
  if (is_full(list)) return;
  if (list.size() == most_violations) {
    list.push_back({"", "there are more faults than these " + std::to_string(most_violations) +
                            "; correct them, and the rest is listed"});
    return;
  }
  violation.field = cut_short(std::move(violation.field), longest_field);
  violation.rule = cut_short(std::move(violation.rule), longest_rule);
  list.push_back(std::move(violation));
}

bool is_full(const Violations& list) { return list.size() > most_violations; }

Violations shortened(const Violations& violations) {
  Violations list;
  for (const Violation& violation : violations) {
    if (is_full(list)) break;
    note(list, violation);
  }
  return list;
}

std::string cut_short(std::string text, std::size_t most_bytes) {
  assert(most_bytes >= ellipsis.size());
  if (text.size() <= most_bytes) return text;
  std::size_t end = most_bytes - ellipsis.size();
  while (end > 0 && continues(text[end])) --end;
  text.resize(end);
  text += ellipsis;
  return text;
}

}  // namespace floeplan::core
