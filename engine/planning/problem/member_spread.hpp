#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace floeplan::planning {

/// A figure of one route over the members of uncertain currents, of which less is better. A member in which the route
/// is not possible has none: it counts as more than every other.
class MemberSpread {
 public:
  /// The figure in each member, empty where the route is not possible.
  /// Errors  std::invalid_argument for no members
  explicit MemberSpread(const std::vector<std::optional<double>>& of_members);

  /// Members in which the route is possible.
  [[nodiscard]] std::size_t known() const { return sorted_.size(); }
  /// Of the members in which the route is possible; empty when there is none.
  [[nodiscard]] std::optional<double> mean() const;
  /// Of those members, with one degree of freedom taken by the mean; empty for fewer than two.
  [[nodiscard]] std::optional<double> standard_deviation() const;
  /// What this share of all members does not exceed, linear between the members' figures; empty where it would take a
  /// member in which the route is not possible.
  /// Source  Hyndman and Fan 1996, Sample quantiles in statistical packages, The American Statistician 50, type 7
  [[nodiscard]] std::optional<double> quantile(double share) const;
  /// Share of all members whose figure is no more.
  [[nodiscard]] double share_within(double most) const;

 private:
  std::size_t members_;
  std::vector<double> sorted_;  // of those in which the route is possible
};

}  // namespace floeplan::planning
