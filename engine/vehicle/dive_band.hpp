#pragma once

#include <optional>

#include "engine/core/units.hpp"

namespace floeplan::vehicle {

/// The depths between which a glider saw-tooths. A steady saw-tooth spends the same time in every layer of
/// equal thickness: it climbs and dives at a constant rate.
struct DiveBand {
  core::Metres top;
  core::Metres bottom;

  [[nodiscard]] core::Metres thickness() const { return bottom - top; }
  friend bool operator==(const DiveBand&, const DiveBand&) = default;
};

/// What the pilot asks of the saw-tooth.
struct DiveLimits {
  core::Metres climb_to{5.0};
  core::Metres dive_to{200.0};
  core::Metres altimeter_margin{10.0};  // kept above the sea bed

  friend bool operator==(const DiveLimits&, const DiveLimits&) = default;
};

/// No lower saw-tooth is flown: what a glider sinks on while it turns round.
inline constexpr core::Metres lowest_tooth{2.0};

/// The depths really flown over a sea bed: from climb_to to the lesser of dive_to and the bed less the margin,
/// at least `lowest_tooth` apart (in such shallow water a vertex is closed anyhow). No bed known: as deep as
/// asked.
[[nodiscard]] DiveBand flown_band(const DiveLimits& limits, std::optional<core::Metres> sea_bed);

/// The band where no dive turns above `upper_turn`; where that leaves less than the lowest saw-tooth, that one.
[[nodiscard]] DiveBand band_below(core::Metres upper_turn, const DiveBand& band);

}  // namespace floeplan::vehicle
