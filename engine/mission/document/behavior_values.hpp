#pragma once

#include <optional>
#include <string_view>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// The value of an argument of a behavior, or the dictionary's default. Empty if neither is known, and for a
/// mission parameter of a back-seat driver.
[[nodiscard]] std::optional<double> value_of(const Behavior& behavior, std::string_view name);

/// Whether the behavior's arguments are in a file of their own.
[[nodiscard]] bool reads_file(const Behavior& behavior);

}  // namespace floeplan::mission
