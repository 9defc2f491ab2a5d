#include "engine/planning/problem/member_spread.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace floeplan::planning {

MemberSpread::MemberSpread(const std::vector<std::optional<double>>& of_members)
    : members_{of_members.size()} {
  if (of_members.empty()) throw std::invalid_argument{"a spread has at least one member"};
  for (const auto& figure : of_members) {
    if (figure) sorted_.push_back(*figure);
  }
  std::ranges::sort(sorted_);
}

std::optional<double> MemberSpread::mean() const {
  if (sorted_.empty()) return std::nullopt;
  return std::accumulate(sorted_.begin(), sorted_.end(), 0.0) / static_cast<double>(sorted_.size());
}

std::optional<double> MemberSpread::standard_deviation() const {
  if (sorted_.size() < 2) return std::nullopt;
  const double middle = *mean();
  double squares = 0.0;
  for (const double figure : sorted_) squares += (figure - middle) * (figure - middle);
  return std::sqrt(squares / static_cast<double>(sorted_.size() - 1));
}

std::optional<double> MemberSpread::quantile(double share) const {
  const double position = share * static_cast<double>(members_ - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const auto above = static_cast<std::size_t>(std::ceil(position));
  if (above >= sorted_.size()) return std::nullopt;
  const double part = position - static_cast<double>(below);
  return sorted_[below] + part * (sorted_[above] - sorted_[below]);
}

double MemberSpread::share_within(double most) const {
  const auto beyond = std::ranges::upper_bound(sorted_, most);
  return static_cast<double>(beyond - sorted_.begin()) / static_cast<double>(members_);
}

}  // namespace floeplan::planning
