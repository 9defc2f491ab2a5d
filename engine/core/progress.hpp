#pragma once

#include <cmath>
#include <functional>
#include <string_view>

namespace floeplan::core {

/// Told now and then by long work: a stage in words ("search"), after a colon more of it for who has room ("not possible
/// as asked: the goal lies on land"), and the share of the whole that is done, 0 to 1. Called on the thread that does the work; must be cheap; never from an innermost loop.
using ProgressCallback = std::function<void(std::string_view stage, double fraction)>;

/// The progress of one part of a work as progress of the whole, which it takes from `from` to `to`. Its stages are told
/// as the one `stage`. `whole` and `stage` are borrowed and outlive the result; where `whole` is empty, the result is.
inline ProgressCallback part_of(const ProgressCallback& whole, std::string_view stage, double from,
                                double to) {
  if (!whole) return {};
  return [&whole, stage, from, to](std::string_view, double fraction) {
    whole(stage, std::lerp(from, to, fraction));
  };
}

}  // namespace floeplan::core
