#pragma once

#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace floeplan::core {

/// Long work calls it now and then, on its own thread. The stage is in words ("search"); after a colon stands more of it, for
/// places with room ("not possible as asked: the goal lies on land"). The fraction is the share of the whole work that is
/// done, 0 to 1. It must be cheap, and is never called from an innermost loop.
using ProgressCallback = std::function<void(std::string_view stage, double fraction)>;

/// The progress of one part of a work as progress of the whole, which it takes from `from` to `to`. Its stages are told
/// as the one `stage`, or as they are where that is empty. `whole` and `stage` are borrowed and outlive the result; where
/// `whole` is empty, the result is.
inline ProgressCallback part_of(const ProgressCallback& whole, std::string_view stage, double from,
                                double to) {
  if (!whole) return {};
  return [&whole, stage, from, to](std::string_view told, double fraction) {
    whole(stage.empty() ? told : stage, std::lerp(from, to, fraction));
  };
}

/// Shares out the progress of a work whose number of parts is not known before: each part gets half of what is left.
class PartsOfProgress {
 public:
  /// Both are borrowed and outlive the parts.
  PartsOfProgress(const ProgressCallback& whole, std::string_view stage) : whole_{whole}, stage_{stage} {}

  /// The progress of the next part.
  [[nodiscard]] ProgressCallback next() {
    const double from = std::exchange(done_, 0.5 * (1.0 + done_));
    return part_of(whole_, stage_, from, done_);
  }

 private:
  const ProgressCallback& whole_;
  std::string_view stage_;
  double done_{0.0};
};

}  // namespace floeplan::core
