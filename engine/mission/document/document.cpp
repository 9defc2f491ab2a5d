#include "engine/mission/document/document.hpp"

#include <algorithm>
#include <utility>

namespace floeplan::mission {

const Argument* Behavior::find(std::string_view argument_name) const {
  const auto found = std::ranges::find(arguments, argument_name, &Argument::name);
  return found == arguments.end() ? nullptr : &*found;
}

void report(Document& document, int line, const messages::Message& message) {
  document.messages.push_back(finding(line, message));
}

}  // namespace floeplan::mission
