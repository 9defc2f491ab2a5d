#include "engine/planning/problem/infeasible.hpp"

namespace floeplan::planning {
namespace {

/// Capitalises the text: refusals begin with a small letter, because they usually follow a colon.
std::string as_sentence(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

std::string Infeasible::explanation() const {
  std::string text = why.text;
  for (const messages::Message& more : besides) text += ". " + as_sentence(more.text);
  return text;
}

std::string Infeasible::suggestion() const {
  std::string hint = why.hint;
  for (const messages::Message& more : besides)
    if (!more.hint.empty()) hint = more.hint;
  return hint;
}

}  // namespace floeplan::planning
