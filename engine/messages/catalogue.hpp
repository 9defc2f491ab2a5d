#pragma once

#include <vector>

#include "engine/messages/kind.hpp"

namespace floeplan::messages {

/// All kinds of messages: about plans and their data, refusals and their phrases, exports.
[[nodiscard]] std::vector<Kind> catalogue();

}  // namespace floeplan::messages
