#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>

#include "engine/planning/cost/leg_cost.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning::refinement {

/// Work limit of refinement. Work is counted and not measured by a clock, so that one request gives the same route on
/// every machine.
struct RefinementBudget {
  std::int64_t most_evaluations{1'000'000};  // of legs
  std::stop_token stop{};
};

/// Times legs, adds up their cost and counts them. Once the budget is used up every leg counts as closed, so nothing
/// found later can be accepted.
/// Threads  one at a time
template <cost::CostedLeg Leg>
class LegMeter {
 public:
  LegMeter(const Leg& leg, RefinementBudget budget) : leg_{leg}, budget_{std::move(budget)} {}

  [[nodiscard]] std::optional<cost::LegCost> operator()(geo::PlanePoint a, geo::PlanePoint b,
                                                        core::Seconds depart) {
    if (has_ended()) return std::nullopt;
    ++evaluations_;
    const auto taken = leg_(a, b, depart);
    if (!taken.has_value()) return std::nullopt;
    return cost::cost_of_leg(*taken);
  }

  /// The route with its times and costs; empty if a leg is closed.
  [[nodiscard]] std::optional<cost::Itinerary> timed(cost::Route route, core::Seconds depart) {
    cost::Itinerary result{std::move(route), {depart}, {0.0}};
    const auto& points = result.route.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto leg = (*this)(points[i - 1], points[i], result.times.back());
      if (!leg) return std::nullopt;
      result.append(*leg);
    }
    return result;
  }

  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
  /// Share of the allowed evaluations that is used.
  [[nodiscard]] double spent() const {
    return static_cast<double>(evaluations_) / static_cast<double>(budget_.most_evaluations);
  }
  [[nodiscard]] RefinementEnd end() const { return end_; }

 private:
  bool has_ended() {
    if (end_ != RefinementEnd::converged) return true;
    if (budget_.stop.stop_requested()) {
      end_ = RefinementEnd::cancelled;
    } else if (evaluations_ >= budget_.most_evaluations) {
      end_ = RefinementEnd::evaluations;
    }
    return end_ != RefinementEnd::converged;
  }

  const Leg& leg_;
  RefinementBudget budget_;
  std::int64_t evaluations_{};
  RefinementEnd end_{RefinementEnd::converged};
};

}  // namespace floeplan::planning::refinement
