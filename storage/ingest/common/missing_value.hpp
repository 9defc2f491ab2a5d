#pragma once

#include <limits>

namespace floeplan::ingest {

/// Marks grid nodes without a value.
inline constexpr float missing = std::numeric_limits<float>::quiet_NaN();

}  // namespace floeplan::ingest
