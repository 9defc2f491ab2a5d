#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace floeplan::planning {

/// A figure of one route, such as its cost, in each member of uncertain currents. Less is better. A member in
/// which the route is closed has no figure and counts as worse than every other.
class MemberSpread {
 public:
  /// The figure in each member, empty where the route is closed.
  /// Errors  std::invalid_argument for no members
  explicit MemberSpread(const std::vector<std::optional<double>>& of_members);

  /// Number of members in which the route is open.
  [[nodiscard]] std::size_t known() const { return sorted_.size(); }
  /// The mean over the members in which the route is open; empty if there are no such members.
  [[nodiscard]] std::optional<double> mean() const;
  /// The standard deviation over the members in which the route is open, with n - 1 degrees of freedom; empty
  /// for fewer than two such members.
  [[nodiscard]] std::optional<double> standard_deviation() const;
  /// The figure that `share` (0 to 1) of all members does not exceed, interpolated linearly between members.
  /// Empty if the interpolation needs a member in which the route is closed.
  /// Source  Hyndman and Fan 1996, Sample quantiles in statistical packages, The American Statistician 50,
  ///         type 7
  [[nodiscard]] std::optional<double> quantile(double share) const;
  /// Share of all members whose figure is at most `most`.
  [[nodiscard]] double share_within(double most) const;

 private:
  std::size_t members_;
  std::vector<double> sorted_;  // figures of the members in which the route is open
};

}  // namespace floeplan::planning
