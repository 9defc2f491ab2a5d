#pragma once

#include <optional>

#include "engine/core/units.hpp"

namespace floeplan::vehicle {

/// The depths between which a glider dives (saw-tooth). It climbs and dives at a constant rate, so it spends
/// the same time in every layer of equal thickness.
struct DiveBand {
  core::Metres top;
  core::Metres bottom;

  [[nodiscard]] core::Metres thickness() const { return bottom - top; }
  friend bool operator==(const DiveBand&, const DiveBand&) = default;
};

/// The depths that the pilot requests for the dives.
struct DiveLimits {
  core::Metres climb_to{5.0};
  core::Metres dive_to{200.0};
  core::Metres altimeter_margin{10.0};  // distance kept above the sea bed

  friend bool operator==(const DiveLimits&, const DiveLimits&) = default;
};

/// Least height of a saw-tooth: a glider sinks this far while it turns.
inline constexpr core::Metres lowest_tooth{2.0};

/// The depths that are really flown over a sea bed: from climb_to down to dive_to, or to the bed minus the
/// margin if that is higher. They are at least `lowest_tooth` apart; shallower water is closed anyway. Empty
/// bed: unknown, dive_to counts.
[[nodiscard]] DiveBand flown_band(const DiveLimits& limits, std::optional<core::Metres> sea_bed);

/// The band if no dive may turn above `upper_turn`. If less than `lowest_tooth` is left, the lowest part of
/// that height.
[[nodiscard]] DiveBand band_below(core::Metres upper_turn, const DiveBand& band);

}  // namespace floeplan::vehicle
