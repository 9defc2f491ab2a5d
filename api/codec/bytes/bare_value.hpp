#pragma once

#include <optional>

#include "engine/core/units.hpp"

namespace floeplan::codec {

/// The number without its unit, for texts that state the unit elsewhere.
template <class Tag>
[[nodiscard]] std::optional<double> bare(const std::optional<core::Quantity<Tag>>& quantity) {
  return quantity ? std::optional{quantity->value} : std::nullopt;
}

}  // namespace floeplan::codec
