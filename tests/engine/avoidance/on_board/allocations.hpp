#pragma once

#include <cstddef>

namespace floeplan::support {

/// How often this program has taken a block from the heap so far.
[[nodiscard]] std::size_t allocations();

}  // namespace floeplan::support
