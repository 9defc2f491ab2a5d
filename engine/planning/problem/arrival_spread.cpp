#include "engine/planning/problem/arrival_spread.hpp"

#include <utility>

namespace floeplan::planning {
namespace {

MemberSpread spread_of(const std::vector<std::optional<core::Seconds>>& travel_times) {
  std::vector<std::optional<double>> seconds;
  seconds.reserve(travel_times.size());
  for (const auto& time : travel_times) seconds.push_back(time ? std::optional{time->count()} : std::nullopt);
  return MemberSpread{seconds};
}

std::optional<core::Seconds> in_seconds(std::optional<double> figure) {
  return figure ? std::optional{core::Seconds{*figure}} : std::nullopt;
}

}  // namespace

ArrivalSpread::ArrivalSpread(std::vector<std::optional<core::Seconds>> travel_times)
    : travel_times_{std::move(travel_times)}, spread_{spread_of(travel_times_)} {}

std::optional<core::Seconds> ArrivalSpread::mean() const { return in_seconds(spread_.mean()); }

std::optional<core::Seconds> ArrivalSpread::standard_deviation() const {
  return in_seconds(spread_.standard_deviation());
}

std::optional<core::Seconds> ArrivalSpread::quantile(double share) const {
  return in_seconds(spread_.quantile(share));
}

double ArrivalSpread::chance_within(core::Seconds time) const { return spread_.share_within(time.count()); }

}  // namespace floeplan::planning
