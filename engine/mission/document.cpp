#include "engine/mission/document.hpp"

#include <algorithm>

namespace floeplan::mission {

const Argument* Behavior::find(std::string_view argument_name) const {
  const auto found = std::ranges::find(arguments, argument_name, &Argument::name);
  return found == arguments.end() ? nullptr : &*found;
}

}  // namespace floeplan::mission
