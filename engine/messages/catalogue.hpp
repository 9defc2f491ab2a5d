#pragma once

#include <vector>

#include "engine/messages/kind.hpp"

namespace floeplan::messages {

/// All kinds of messages of the engine and of its data, in the order of their headers.
[[nodiscard]] std::vector<Kind> catalogue();

}  // namespace floeplan::messages
