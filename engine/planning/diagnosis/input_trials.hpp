#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>

#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// What a trial tells of another request in the same sea.
enum class TrialOutcome {
  possible,
  impossible,
  not_known  // the work set aside for it was done before it was decided
};
using Trial = std::function<TrialOutcome(const PlanRequest&)>;

/// Tries values of one input after the other until the least change is found that makes a request possible.
/// Once a trial told nothing, no more is tried of the input at hand.
class InputTrials {
 public:
  static constexpr core::Seconds an_hour{3600.0};

  /// Both are borrowed and outlive this.
  InputTrials(const Trial& trial, const std::stop_token& stop) : trial_{trial}, stop_{stop} {}

  void begin_input() { told_nothing_ = false; }
  /// Whether no more is to be tried of the input at hand.
  [[nodiscard]] bool is_over() const { return told_nothing_ || stop_.stop_requested(); }
  /// Whether some trial told nothing.
  [[nodiscard]] bool told_too_little() const { return told_too_little_; }
  /// The request of the last trial that found a way; empty before there was one.
  [[nodiscard]] const std::optional<PlanRequest>& last_possible() const { return last_possible_; }

  bool works(const PlanRequest& request) { return works_by(trial_, request); }
  /// By another trial, of another sea.
  bool works_by(const Trial& trial, const PlanRequest& request) {
    const TrialOutcome outcome = outcome_of(trial, request);
    if (outcome == TrialOutcome::not_known) told_nothing_ = true;
    return outcome == TrialOutcome::possible;
  }

  /// The value nearest to `now` that helps, on the way to `extreme`, as a multiple of `unit`. `with`: the request
  /// with a value.
  template <class With>
  std::optional<double> nearest_that_helps(double now, double extreme, double unit, const With& with) {
    // Rounded towards the generous end, so that what is named is what was tried.
    const auto between = [&](double a, double b) {
      const double middle = 0.5 * (a + b);
      return unit * (extreme > now ? std::ceil(middle / unit) : std::floor(middle / unit));
    };
    begin_input();
    double helps = extreme;
    TrialOutcome outcome = TrialOutcome::not_known;
    for (int i = 0; i < most_beginnings && helps != now && !is_over(); ++i) {
      outcome = outcome_of(trial_, with(helps));
      if (outcome != TrialOutcome::not_known) break;
      helps = between(now, helps);
    }
    if (outcome != TrialOutcome::possible) return std::nullopt;
    double fails = now;
    for (int i = 0; i < halvings && !is_over(); ++i) {
      const double middle = between(fails, helps);
      if (middle == helps || middle == fails) break;
      (outcome_of(trial_, with(middle)) == TrialOutcome::possible ? helps : fails) = middle;
    }
    return helps;
  }

 private:
  static constexpr int halvings = 7;  // to a hundredth, with a speed or margin rounded to what one would type
  static constexpr int most_beginnings = 3;  // of a value, where the most generous one tells nothing

  TrialOutcome outcome_of(const Trial& trial, const PlanRequest& request) {
    if (!request.violations().empty()) return TrialOutcome::impossible;
    const TrialOutcome outcome = trial(request);
    if (outcome == TrialOutcome::not_known) told_too_little_ = true;
    if (outcome == TrialOutcome::possible) last_possible_ = request;
    return outcome;
  }

  const Trial& trial_;
  const std::stop_token& stop_;
  bool told_nothing_{false};     // a trial of the input at hand
  bool told_too_little_{false};  // likewise of any input
  std::optional<PlanRequest> last_possible_{};
};

}  // namespace floeplan::planning::diagnosis
