#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// How one route fares in each member of uncertain currents. A member in which the route is not possible never
/// arrives: it counts as later than every other.
class ArrivalSpread {
 public:
  /// Travel time in each member, empty where the route is not possible. At least one member.
  explicit ArrivalSpread(std::vector<std::optional<core::Seconds>> travel_times);

  [[nodiscard]] const std::vector<std::optional<core::Seconds>>& travel_times() const {
    return travel_times_;
  }
  [[nodiscard]] std::size_t arrived() const { return sorted_s_.size(); }
  /// Of the members that arrive; empty when none does.
  [[nodiscard]] std::optional<core::Seconds> mean() const;
  /// Of the members that arrive, with one degree of freedom taken by the mean; empty for fewer than two.
  [[nodiscard]] std::optional<core::Seconds> standard_deviation() const;
  /// Time that this share of all members keeps, linear between the members' times; empty where it would take a member
  /// that does not arrive.
  /// Source  Hyndman and Fan 1996, Sample quantiles in statistical packages, The American Statistician 50, type 7
  [[nodiscard]] std::optional<core::Seconds> quantile(double share) const;
  /// Share of all members that arrive within the time.
  [[nodiscard]] double chance_within(core::Seconds time) const;

 private:
  std::vector<std::optional<core::Seconds>> travel_times_;
  std::vector<double> sorted_s_;  // of those that arrive
};

}  // namespace floeplan::planning
