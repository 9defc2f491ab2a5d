#pragma once

#include <vector>

#include "engine/messages/kind.hpp"

namespace floeplan::messages {

/// All kinds of messages of plans, of their data and of refusals, and the phrases in these.
[[nodiscard]] std::vector<Kind> catalogue();

}  // namespace floeplan::messages
