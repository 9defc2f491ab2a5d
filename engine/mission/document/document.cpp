#include "engine/mission/document/document.hpp"

#include <algorithm>
#include <utility>

namespace floeplan::mission {

const Argument* Behavior::find(std::string_view argument_name) const {
  const auto found = std::ranges::find(arguments, argument_name, &Argument::name);
  return found == arguments.end() ? nullptr : &*found;
}

void report(Document& document, int line, Severity severity, const char* code, std::string text) {
  document.messages.push_back({line, severity, code, std::move(text)});
}

}  // namespace floeplan::mission
