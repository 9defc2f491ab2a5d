#pragma once

#include <limits>

#include "api/codec/reading/input_reader.hpp"

/// Limits that the inputs of several processes share.
namespace floeplan::codec {

/// Any finite number; for numbers whose range is checked elsewhere.
inline constexpr NumberRange any_number{std::numeric_limits<double>::lowest(),
                                        std::numeric_limits<double>::max()};

}  // namespace floeplan::codec
