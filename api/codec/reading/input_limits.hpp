#pragma once

#include <limits>

#include "api/codec/reading/input_reader.hpp"

/// Limits that the inputs of several processes share.
namespace floeplan::codec {

/// Of a number that its receiver judges: every finite one.
inline constexpr NumberRange any_number{std::numeric_limits<double>::lowest(),
                                        std::numeric_limits<double>::max()};

}  // namespace floeplan::codec
