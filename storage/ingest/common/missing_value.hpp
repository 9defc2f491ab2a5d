#pragma once

#include <limits>

namespace floeplan::ingest {

/// What stands where a field has no value.
inline constexpr float missing = std::numeric_limits<float>::quiet_NaN();

}  // namespace floeplan::ingest
