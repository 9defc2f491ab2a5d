#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>

#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The result of a trial: whether another request on the same data has a route.
enum class TrialOutcome {
  possible,
  impossible,
  not_known  // the work reserved for the trial was used up before the answer was known
};
using Trial = std::function<TrialOutcome(const PlanRequest&)>;

/// Tries values of one input until the smallest change is found that makes a request possible. After a trial without
/// an answer, no more values of this input are tried.
class InputTrials {
 public:
  static constexpr core::Seconds an_hour{3600.0};

  /// Both are borrowed and must outlive this object.
  InputTrials(const Trial& trial, const std::stop_token& stop) : trial_{trial}, stop_{stop} {}

  void begin_input() { told_nothing_ = false; }
  /// Whether the search for a value of the present input must end.
  [[nodiscard]] bool is_over() const { return told_nothing_ || stop_.stop_requested(); }
  /// Whether some trial gave no answer.
  [[nodiscard]] bool told_too_little() const { return told_too_little_; }
  /// The request of the last trial that found a route; empty before the first one.
  [[nodiscard]] const std::optional<PlanRequest>& last_possible() const { return last_possible_; }

  bool works(const PlanRequest& request) { return works_by(trial_, request); }
  /// Whether the request has a plan by this trial, which may use other data than the trial of `works`.
  bool works_by(const Trial& trial, const PlanRequest& request) {
    const TrialOutcome outcome = outcome_of(trial, request);
    if (outcome == TrialOutcome::not_known) told_nothing_ = true;
    return outcome == TrialOutcome::possible;
  }

  /// The value nearest to `now` that helps, between `now` and `extreme`, rounded to `unit`. `with(value)`:
  /// the request with this value.
  template <class With>
  std::optional<double> nearest_that_helps(double now, double extreme, double unit, const With& with) {
    // Rounded towards `extreme`, so that the proposed value was itself tried.
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
  static constexpr int halvings = 7;  // to a hundredth of the interval; typed values are no finer
  static constexpr int most_beginnings =
      3;  // values that are tried first when the most generous one gives no answer

  TrialOutcome outcome_of(const Trial& trial, const PlanRequest& request) {
    if (!request.violations().empty()) return TrialOutcome::impossible;
    const TrialOutcome outcome = trial(request);
    if (outcome == TrialOutcome::not_known) told_too_little_ = true;
    if (outcome == TrialOutcome::possible) last_possible_ = request;
    return outcome;
  }

  const Trial& trial_;
  const std::stop_token& stop_;
  bool told_nothing_{false};     // a trial of the present input gave no answer
  bool told_too_little_{false};  // a trial of some input gave no answer
  std::optional<PlanRequest> last_possible_{};
};

}  // namespace floeplan::planning::diagnosis
