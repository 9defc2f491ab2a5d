#include "engine/planning/problem/infeasible.hpp"

namespace floeplan::planning {

std::string Infeasible::explanation() const {
  std::string text = why.text;
  for (const messages::Message& more : besides) text += "; " + more.text;
  return text;
}

std::string Infeasible::suggestion() const {
  std::string hint = why.hint;
  for (const messages::Message& more : besides)
    if (!more.hint.empty()) hint = more.hint;
  return hint;
}

}  // namespace floeplan::planning
