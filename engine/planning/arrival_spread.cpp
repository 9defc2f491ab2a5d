#include "engine/planning/arrival_spread.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace floeplan::planning {

ArrivalSpread::ArrivalSpread(std::vector<std::optional<core::Seconds>> travel_times)
    : travel_times_{std::move(travel_times)} {
  if (travel_times_.empty()) throw std::invalid_argument{"a spread has at least one member"};
  for (const auto& time : travel_times_) {
    if (time) sorted_s_.push_back(time->count());
  }
  std::ranges::sort(sorted_s_);
}

std::optional<core::Seconds> ArrivalSpread::mean() const {
  if (sorted_s_.empty()) return std::nullopt;
  const double sum = std::accumulate(sorted_s_.begin(), sorted_s_.end(), 0.0);
  return core::Seconds{sum / static_cast<double>(sorted_s_.size())};
}

std::optional<core::Seconds> ArrivalSpread::standard_deviation() const {
  if (sorted_s_.size() < 2) return std::nullopt;
  const double mean_s = mean()->count();
  double squares = 0.0;
  for (const double time_s : sorted_s_) squares += (time_s - mean_s) * (time_s - mean_s);
  return core::Seconds{std::sqrt(squares / static_cast<double>(sorted_s_.size() - 1))};
}

std::optional<core::Seconds> ArrivalSpread::quantile(double share) const {
  const double position = share * static_cast<double>(travel_times_.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const auto above = static_cast<std::size_t>(std::ceil(position));
  if (above >= sorted_s_.size()) return std::nullopt;
  const double part = position - static_cast<double>(below);
  return core::Seconds{sorted_s_[below] + part * (sorted_s_[above] - sorted_s_[below])};
}

double ArrivalSpread::chance_within(core::Seconds time) const {
  const auto late = std::ranges::upper_bound(sorted_s_, time.count());
  return static_cast<double>(late - sorted_s_.begin()) / static_cast<double>(travel_times_.size());
}

}  // namespace floeplan::planning
