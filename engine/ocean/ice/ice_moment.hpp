#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// Up to this long between two steps the data tell of all the time between: daily data, one of them missing at most.
inline constexpr core::Seconds longest_ice_step{2.0 * 86400.0};
/// Up to this long between two steps the ice is interpolated for want of better data: charts come once a week. In a
/// longer gap the nearest step is held, as beyond the period.
inline constexpr core::Seconds longest_ice_gap{8.0 * 86400.0};

/// For how long beyond its steps, before and after, a plan takes the ice to stay as the nearest of them has it.
/// Analyses come once a day and with a delay of a day or two; floes drift ten kilometres or so a day, so that an older
/// one says little of where the edge is.
inline constexpr core::Seconds longest_ice_hold{3.0 * 86400.0};

/// For how long beyond its steps ice counts before other data that are only held: analyses come once a day, many as
/// the mean of a day that is given as its noon.
inline constexpr core::Seconds ice_speaks_before{0.5 * 86400.0};
inline constexpr core::Seconds ice_speaks_after{1.0 * 86400.0};

/// What the steps of ice data tell of a time, the least first.
enum class IceStanding {
  not_begun,  // all of them are long after it
  unknown,    // none is near enough, some are before it
  held,       // a step is near enough for want of others, or lies on either side of it
  speaks,     // a step is near
  own         // it is a step, or lies between two that are not far apart
};

/// The steps to take the ice of a time from. Where nothing is known: those around it, which tell what was known last.
struct IceMoment {
  std::size_t first{};
  std::size_t second{};
  double share{};  // of the way from the first to the second
  IceStanding standing{};
  core::Seconds away{};  // from the nearest step

  [[nodiscard]] bool is_known() const { return standing >= IceStanding::held; }
};

/// Shape    `times_s` ascend strictly and are not empty, on the same clock as `time_s`
[[nodiscard]] IceMoment ice_moment(const std::vector<double>& times_s, double time_s);

}  // namespace floeplan::ocean
