#pragma once

#include <functional>

#include "engine/core/units.hpp"

namespace floeplan::core {

/// Seconds since an instant that does not matter, by a steady clock that the caller owns: pure code has none.
/// Empty: no time passes, nothing is cut short.
using SteadyClock = std::function<Seconds()>;

}  // namespace floeplan::core
