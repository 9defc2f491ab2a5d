#pragma once

#include <cstddef>

namespace floeplan::support {

/// Number of blocks that this program has allocated on the heap so far.
[[nodiscard]] std::size_t allocations();

}  // namespace floeplan::support
