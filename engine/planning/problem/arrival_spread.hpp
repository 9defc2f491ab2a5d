#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/planning/problem/member_spread.hpp"

namespace floeplan::planning {

/// Travel times of one route in each member of uncertain currents. In a member in which the route is closed
/// the vehicle never arrives; such a member counts as later than every other.
class ArrivalSpread {
 public:
  /// Travel time in each member, empty where the route is closed. At least one member.
  explicit ArrivalSpread(std::vector<std::optional<core::Seconds>> travel_times);

  [[nodiscard]] const std::vector<std::optional<core::Seconds>>& travel_times() const {
    return travel_times_;
  }
  [[nodiscard]] std::size_t arrived() const { return spread_.known(); }
  /// The mean over the members that arrive; empty when none arrives.
  [[nodiscard]] std::optional<core::Seconds> mean() const;
  /// The standard deviation over the members that arrive; empty for fewer than two.
  [[nodiscard]] std::optional<core::Seconds> standard_deviation() const;
  /// The travel time within which this share (0 to 1) of all members arrives; empty if too few members
  /// arrive.
  [[nodiscard]] std::optional<core::Seconds> quantile(double share) const;
  /// Share of all members that arrive within this travel time.
  [[nodiscard]] double chance_within(core::Seconds time) const;

 private:
  std::vector<std::optional<core::Seconds>> travel_times_;
  MemberSpread spread_;  // of travel times in seconds
};

}  // namespace floeplan::planning
