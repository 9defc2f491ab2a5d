#pragma once

#include <functional>
#include <string_view>

namespace floeplan::core {

/// Told now and then by long work: a stage in words ("search") and the share of the whole that is done, 0
/// to 1. Called on the thread that does the work; must be cheap; never from an innermost loop.
using ProgressCallback = std::function<void(std::string_view stage, double fraction)>;

}  // namespace floeplan::core
