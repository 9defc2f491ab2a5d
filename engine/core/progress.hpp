#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace floeplan::core {

/// Called from time to time by long work, on its own thread. `stage` is a word or two ("search"); details may
/// follow after a colon ("not possible as asked: the goal lies on land"). `fraction` is the share of the
/// whole work that is done, 0 to 1. The callback must be cheap; it is never called from an innermost loop.
using ProgressCallback = std::function<void(std::string_view stage, double fraction)>;

/// The progress of a part of the work, scaled to the progress of the whole between `from` and `to`. All
/// stages of the part are reported as `stage`, or unchanged if `stage` is empty. `whole` and `stage` are
/// borrowed and must outlive the result. If `whole` is empty, so is the result.
inline ProgressCallback part_of(const ProgressCallback& whole, std::string_view stage, double from,
                                double to) {
  if (!whole) return {};
  return [&whole, stage, from, to](std::string_view told, double fraction) {
    whole(stage.empty() ? told : stage, std::lerp(from, to, fraction));
  };
}

/// Progress that never falls and stays between 0 and 1. Work may have to start again, on another grid or in a
/// wider area; its share then stands still until it exceeds what was reported before. `listener` is borrowed
/// and must outlive the result; if it is empty, the result does nothing.
inline ProgressCallback never_falling(const ProgressCallback& listener) {
  if (!listener) return [](std::string_view, double) {};
  return [&listener, most = 0.0](std::string_view stage, double fraction) mutable {
    most = std::clamp(fraction, most, 1.0);
    listener(stage, most);
  };
}

/// Divides the progress of work whose number of parts is not known in advance: each part gets a share of the
/// rest.
class PartsOfProgress {
 public:
  /// The share where the first part is mostly the only one. A judgement.
  static constexpr double mostly_one = 0.8;

  /// `whole` and `stage` are borrowed and must outlive the parts.
  PartsOfProgress(const ProgressCallback& whole, std::string_view stage, double of_the_rest = 0.5)
      : whole_{whole}, stage_{stage}, of_the_rest_{of_the_rest} {}

  /// The progress of the next part.
  [[nodiscard]] ProgressCallback next() {
    const double from = std::exchange(done_, std::lerp(done_, 1.0, of_the_rest_));
    return part_of(whole_, stage_, from, done_);
  }

 private:
  const ProgressCallback& whole_;
  std::string_view stage_;
  double of_the_rest_;
  double done_{0.0};
};

}  // namespace floeplan::core
