#pragma once

#include <vector>

#include "engine/messages/kind.hpp"

namespace floeplan::messages {

/// All kinds of messages: of plans, of their data, of refusals with the phrases in them, of exports.
[[nodiscard]] std::vector<Kind> catalogue();

}  // namespace floeplan::messages
