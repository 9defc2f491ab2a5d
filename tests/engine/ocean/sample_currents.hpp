#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "engine/ocean/currents/current_grid.hpp"
#include "tests/engine/ocean/even_axis.hpp"

namespace floeplan::ocean {

/// Where a sample lies: the numbers of its node, level and time.
struct SampleIndex {
  std::size_t ix{};
  std::size_t iy{};
  std::size_t level{};
  std::size_t time{};
};

inline constexpr double first_time_s = 1'700'000'000.0;

/// Currents at 54 W to 51 W by one degree, 68 N to 70 N by one degree, hourly from `first_time_s`.
/// `east` tells the eastward sample; the northward one is minus half of it.
inline CurrentGrid sample_currents(std::optional<Axis> depths_m, std::size_t times,
                                   const std::function<float(SampleIndex)>& east) {
  CurrentGrid::Samples samples{
      .grid = HorizontalGrid{geo::GeographicFrame{}, even_axis(-54.0, 1.0, 4), even_axis(68.0, 1.0, 3)},
      .depths_m = depths_m,
      .times_s = even_axis(first_time_s, 3600.0, times),
      .u = {},
      .v = {}};
  for (std::size_t time = 0; time < times; ++time) {
    for (std::size_t level = 0; level < (depths_m ? depths_m->size() : 1); ++level) {
      for (std::size_t iy = 0; iy < 3; ++iy) {
        for (std::size_t ix = 0; ix < 4; ++ix) {
          samples.u.push_back(east({ix, iy, level, time}));
          samples.v.push_back(-0.5F * samples.u.back());
        }
      }
    }
  }
  return CurrentGrid{std::move(samples)};
}

}  // namespace floeplan::ocean
