#include "engine/avoidance/carried_forecast.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace floeplan::avoidance {
namespace {

/// Interpolation on an axis: the two neighbours of a value, and the weight of the second.
struct Between {
  std::size_t first;
  std::size_t second;
  double weight;
};

Between between(double position, std::size_t size) {
  const double last = static_cast<double>(size - 1);
  const double held = std::clamp(position, 0.0, last);
  const auto first = static_cast<std::size_t>(held);
  return {first, std::min(first + 1, size - 1), held - static_cast<double>(first)};
}

template <class Axis>
Between between(const Axis& axis, typename Axis::value_type value) {
  const auto above = std::ranges::upper_bound(axis, value);
  if (above == axis.begin()) return {0, 0, 0.0};
  if (above == axis.end()) return {axis.size() - 1, axis.size() - 1, 0.0};
  const auto second = static_cast<std::size_t>(above - axis.begin());
  return {second - 1, second, (value - axis[second - 1]) / (axis[second] - axis[second - 1])};
}

template <class Axis>
void require_rising(const Axis& axis, const char* name) {
  const auto not_less = [](const auto& a, const auto& b) { return !(a < b); };
  if (axis.empty() || std::ranges::adjacent_find(axis, not_less) != axis.end()) {
    throw std::invalid_argument{std::string{"the forecast's "} + name + " must be given and rise"};
  }
}

bool is_finite(geo::VelocityEn v) { return std::isfinite(v.east.value) && std::isfinite(v.north.value); }

}  // namespace

CarriedForecast::CarriedForecast(geo::VelocityEn everywhere)
    : CarriedForecast{Grid{
          .depths = {core::Metres{0.0}}, .times = {core::from_unix_seconds(0.0)}, .values = {everywhere}}} {}

CarriedForecast::CarriedForecast(Grid grid) : grid_{std::move(grid)} {
  if (grid_.columns < 1 || grid_.rows < 1 || !(grid_.spacing.value > 0.0)) {
    throw std::invalid_argument{"the forecast needs a column, a row and a spacing above zero"};
  }
  require_rising(grid_.depths, "depths");
  require_rising(grid_.times, "times");
  const std::size_t places = static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows);
  if (grid_.values.size() != places * grid_.depths.size() * grid_.times.size()) {
    throw std::invalid_argument{"the forecast needs one value for each time, depth, row and column"};
  }
  if (!std::ranges::all_of(grid_.values, is_finite)) {
    throw std::invalid_argument{"the forecast's values must be finite"};
  }
}

geo::VelocityEn CarriedForecast::at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const {
  const auto columns = static_cast<std::size_t>(grid_.columns);
  const auto rows = static_cast<std::size_t>(grid_.rows);
  const Between x = between((place.x_m - grid_.origin.x_m) / grid_.spacing.value, columns);
  const Between y = between((place.y_m - grid_.origin.y_m) / grid_.spacing.value, rows);
  const Between z = between(grid_.depths, depth);
  const Between t = between(grid_.times, time);

  geo::VelocityEn sum{};
  for (const auto& [time_index, of_time] :
       {std::pair{t.first, 1.0 - t.weight}, std::pair{t.second, t.weight}}) {
    for (const auto& [depth_index, of_depth] :
         {std::pair{z.first, 1.0 - z.weight}, std::pair{z.second, z.weight}}) {
      for (const auto& [row, of_row] : {std::pair{y.first, 1.0 - y.weight}, std::pair{y.second, y.weight}}) {
        const std::size_t line = ((time_index * grid_.depths.size() + depth_index) * rows + row) * columns;
        const double weight = of_time * of_depth * of_row;
        const geo::VelocityEn a = grid_.values[line + x.first];
        const geo::VelocityEn b = grid_.values[line + x.second];
        sum.east.value += weight * ((1.0 - x.weight) * a.east.value + x.weight * b.east.value);
        sum.north.value += weight * ((1.0 - x.weight) * a.north.value + x.weight * b.north.value);
      }
    }
  }
  return sum;
}

}  // namespace floeplan::avoidance
