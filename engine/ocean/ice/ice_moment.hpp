#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// Two steps at most this far apart describe all the time between: daily data of which at most one is
/// missing.
inline constexpr core::Seconds longest_ice_step{2.0 * 86400.0};
/// Between steps at most this far apart the ice is interpolated, if no better data exist: charts come once a
/// week. In a longer gap the nearest step is held, as outside the period.
inline constexpr core::Seconds longest_ice_gap{8.0 * 86400.0};

/// Outside its steps, before and after, a plan keeps the ice of the nearest step for this time at most.
/// Analyses come once a day with a delay of a day or two; floes drift some ten kilometres a day, so an older
/// analysis says little about the edge.
inline constexpr core::Seconds longest_ice_hold{3.0 * 86400.0};

/// Outside its steps ice data count, for this time, before other data that are only held. Analyses come once
/// a day; many are the mean of a day with its noon as time.
inline constexpr core::Seconds ice_speaks_before{0.5 * 86400.0};
inline constexpr core::Seconds ice_speaks_after{1.0 * 86400.0};

/// How well ice data describe a time; the weakest first.
enum class IceStanding {
  not_begun,  // all steps are long after it
  unknown,    // no step is near enough, but some are before it
  held,       // a step is near enough if there is no better data, or steps lie on both sides
  speaks,     // a step is near
  own         // it is a step, or lies between two that are close together
};

/// The two steps between which the ice of a time is interpolated. If the ice is unknown then, the steps around
/// the time, which give the ice that was last known.
struct IceMoment {
  std::size_t first{};
  std::size_t second{};
  double share{};  // position from the first step to the second, 0 to 1
  IceStanding standing{};
  core::Seconds away{};  // time to the nearest step

  [[nodiscard]] bool is_known() const { return standing >= IceStanding::held; }
};

/// Shape    `times_s`: strictly ascending, not empty, on the same clock as `time_s`
[[nodiscard]] IceMoment ice_moment(const std::vector<double>& times_s, double time_s);

}  // namespace floeplan::ocean
